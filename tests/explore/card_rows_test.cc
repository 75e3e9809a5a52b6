// States of cards as rows of numbers, and steps between rows, beside whole states.
#include "explore/models/card_rows.h"

#include <gtest/gtest.h>

#include <map>
#include <random>
#include <string>

#include "explore_programs.h"
#include "random_machine.h"

namespace oncard::explore {
namespace {

/// Calls `visit` with the state before and after each step of a random run, and the thread.
template <typename Visit>
void ForEachStep(CardModel* model, uint64_t seed, const Visit& visit) {
  std::mt19937_64 random(seed);
  CardModel::State state = model->Start();
  while (!state.ended && !state.finished) {
    int thread = static_cast<int>(random() % static_cast<uint64_t>(model->thread_count()));
    while ((state.choices >> thread & 1) == 0) thread = (thread + 1) % model->thread_count();
    CardModel::State next = model->Step(state, thread);
    visit(state, thread, next);
    state = std::move(next);
  }
}

TEST(CardRows, AreEqualExactlyIfStatesAre) {
  int compared = 0;
  for (uint64_t seed = 1; seed <= 60; ++seed) {
    const RandomMachine machine(seed);
    SCOPED_TRACE(machine.keys() + machine.source());
    CardModel model = CardOf(machine.source(), machine.keys());
    if (!CardRows::Possible(model)) continue;
    CardRows rows(&model, std::make_shared<CardRows::Tables>());
    std::map<StateKey, StateKey> row_of;
    std::map<StateKey, StateKey> state_of;
    for (uint64_t run = 0; run < 4; ++run) {
      ForEachStep(&model, run, [&](const auto& /*before*/, int /*thread*/, const auto& state) {
        model.Load(state);
        const CardRows::Row row = rows.RowOfCard(state);
        const StateKey key = model.KeyOf(state);
        EXPECT_EQ(row_of.try_emplace(key, rows.KeyOf(row)).first->second, rows.KeyOf(row));
        EXPECT_EQ(state_of.try_emplace(rows.KeyOf(row), key).first->second, key);
        // And back.
        const CardModel::State whole = rows.Whole(row);
        EXPECT_EQ(model.KeyOf(whole), key);
        EXPECT_EQ(whole.choices, state.choices);
        EXPECT_EQ(rows.CycleOf(row), CardModel::CycleOf(state));
        ++compared;
      });
    }
    EXPECT_TRUE(rows.exact());
  }
  EXPECT_GE(compared, 1000);
}

TEST(CardRows, AreNotThereWhereMoreThanTheStateMatters) {
  const auto possible = [](const std::string& keys) {
    return CardRows::Possible(CardOf("int n;\nint t0() { n = 1; return 0; }\n", keys));
  };
  EXPECT_TRUE(possible("always = [\"n < 2\"]\n"));
  EXPECT_FALSE(possible("races = \"none\"\n"));
  EXPECT_FALSE(possible("always = [\"statements < 9\"]\n"));
  EXPECT_FALSE(possible("[[world.react]]\nwhen = \"thread0.statements > 1\"\nvalue = 1\n"));
}

}  // namespace
}  // namespace oncard::explore
