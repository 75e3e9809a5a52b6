#include "explore/models/card_rows.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <span>
#include <utility>

#include "explore/models/word_key.h"
#include "runtime/observe/quantity.h"
#include "runtime/scenario/run/reaction_conditions.h"
#include "vm/thread_words.h"

namespace oncard::explore {
namespace {

using runtime::BodyDivision;
using vm::ThreadState;

constexpr uint32_t kNotYet = ~uint32_t{0};

/// Without the zeros at the end, most of which are passed many at once.
std::vector<int64_t> Trimmed(const std::array<int64_t, vm::kSlotCount>& slots) {
  static constexpr std::array<int64_t, 128> kZeros{};
  static_assert(vm::kSlotCount % kZeros.size() == 0);
  size_t count = slots.size();
  while (count > 0 &&
         std::memcmp(&slots[count - kZeros.size()], kZeros.data(), sizeof(kZeros)) == 0) {
    count -= kZeros.size();
  }
  while (count > 0 && slots[count - 1] == 0) --count;
  return {slots.begin(), slots.begin() + static_cast<std::ptrdiff_t>(count)};
}

/// Where the globals end in what CardRows keeps of them.
template <typename Words>
auto EndOfGlobals(Words& words) {
  return words.begin() + static_cast<std::ptrdiff_t>(1 + words.front());
}

void Fill(std::span<const int64_t> values, std::array<int64_t, vm::kSlotCount>* slots) {
  const auto rest = std::copy(values.begin(), values.end(), slots->begin());
  std::fill(rest, slots->end(), 0);
}

}  // namespace

std::optional<Message> CardRows::WhyNot(const CardModel& model) {
  if (model.host_ != nullptr) return Message{"a recorded host acts", "有录制的主机动作"};
  if (model.races_ != nullptr) return Message{"races are looked for", "要查找数据竞争"};
  if (model.counts_statements_) {
    return Message{"a condition counts statements", "有条件引用了语句数"};
  }
  return std::nullopt;
}

CardRows::CardRows(CardModel* model, std::shared_ptr<Tables> tables)
    : model_(*model),
      card_(*model->controller_),
      division_(card_.motion().axis_count()),
      tables_(std::move(tables)),
      faults_(1),
      machine_(std::make_unique<vm::MachineState>(*model->scratch_)),
      body_(card_.Body()),
      body_numbers_(division_.part_count(), ~uint32_t{0}) {
  tables_->body_parts.resize(division_.part_count());
  for (int number = 0; number < vm::kThreadCount; ++number) {
    const ThreadState& thread = machine_->threads[static_cast<size_t>(number)];
    if (thread.run != vm::ThreadRun::kUnbound) numbers_.push_back(number);
  }
  for (const ThreadSetup& setup : model->setups_) {
    const auto found = std::ranges::find(numbers_, setup.thread);
    places_.push_back(static_cast<size_t>(found - numbers_.begin()));
  }
}

// --- Numbers of parts ----------------------------------------------------------------------------

uint32_t CardRows::NumberOfThread(size_t place) {
  const vm::MachineState& machine = card_.machine().state();
  const ThreadState& state = machine.threads[static_cast<size_t>(numbers_[place])];
  // When it starts again depends on more than itself.
  if (state.period_cycles != 0) exact_ = false;
  return NumberOfThread(state, Trimmed(machine.pages[state.page]));
}

uint32_t CardRows::NumberOfThread(const ThreadState& state, std::vector<int64_t> page) {
  const auto words = vm::WordsOf(state);
  key_.assign(words.begin(), words.end() - vm::kCountWords);
  key_.insert(key_.end(), page.begin(), page.end());
  return tables_->threads.NumberOf(KeyOfWords(key_), [&] {
    const vm::Function& function = model_.image_->object.functions[state.function];
    const bool running = state.run == vm::ThreadRun::kRunning;
    tables_->positions.push_back({.wake_cycle = state.wake_cycle,
                                  .pc = state.pc,
                                  .function = state.function,
                                  .running = running,
                                  .waiting = state.waiting,
                                  .at_end = running && state.pc >= function.instructions.size()});
    return Thread{state, std::move(page)};
  });
}

uint32_t CardRows::NumberOfGlobals() {
  const vm::MachineState& machine = card_.machine().state();
  std::vector<int64_t> words = Trimmed(machine.globals);
  words.insert(words.begin(), static_cast<int64_t>(words.size()));
  // The pages of no thread.
  uint32_t pages = machine.pages.used();
  for (const int number : numbers_) {
    pages &= ~(1u << machine.threads[static_cast<size_t>(number)].page);
  }
  for (; pages != 0; pages &= pages - 1) {
    const int number = std::countr_zero(pages);
    const std::vector<int64_t> page = Trimmed(machine.pages[static_cast<size_t>(number)]);
    if (page.empty()) continue;
    words.insert(words.end(), {number, static_cast<int64_t>(page.size())});
    words.insert(words.end(), page.begin(), page.end());
  }
  return NumberOfWords(std::move(words));
}

uint32_t CardRows::NumberOfWords(std::vector<int64_t> globals) {
  return tables_->globals.NumberOf(KeyOfWords(globals), [&] { return std::move(globals); });
}

uint32_t CardRows::NumberOfParts(std::vector<uint32_t> parts) {
  return tables_->bodies.NumberOf(KeyOfWords(parts), [&] {
    Body body = {.parts = std::move(parts), .apart = true};
    PutPart(BodyDivision::kClock, body.parts);
    PutPart(BodyDivision::kWorld, body.parts);
    body.cycle = body_.motion.cycle;
    body.event_soon = EventSoon(body_.motion);
    std::vector<uint32_t> present = body.parts;
    present[BodyDivision::kWorld] = 0;
    bool added = false;
    body.present = tables_->presents.FindOrAdd(KeyOfWords(present), &added);
    for (size_t part = 0; part < body.parts.size(); ++part) {
      body.apart = body.apart && tables_->body_parts[part][body.parts[part]].apart;
    }
    return body;
  });
}

void CardRows::PutPart(size_t part, const std::vector<uint32_t>& numbers) {
  if (body_numbers_[part] == numbers[part]) return;
  division_.Put(tables_->body_parts[part][numbers[part]].value, part, &body_);
  body_numbers_[part] = numbers[part];
}

bool CardRows::EventSoon(const motion::MotionState& state) const {
  const motion::WorldProgress& world = state.world;
  if (world.events == nullptr || world.next >= world.events->size()) return false;
  // A cycle looks at the events up to its end.
  const motion::Micros end = (state.cycle + 2) * card_.motion().config().cycle_us;
  return (*world.events)[static_cast<size_t>(world.next)].at <= end;
}

uint32_t CardRows::NumberOfBody() {
  runtime::CardBody body = card_.Body();
  if (forgets_runs_) {
    for (motion::Profile& profile : body.motion.profiles) profile.ForgetRuns();
  }
  // Instants are those of the clock with which the card has begun.
  if (body.clock) exact_ = false;
  std::vector<uint32_t> parts;
  for (size_t part = 0; part < division_.part_count(); ++part) {
    words_.Clear();
    division_.AddValues(body, part, &words_);
    parts.push_back(tables_->body_parts[part].NumberOf(KeyOfWords(words_.words()), [&] {
      return Tables::BodyPart{division_.PartOf(body, part), division_.LeavesAxesApart(body, part)};
    }));
  }
  return NumberOfParts(std::move(parts));
}

uint32_t CardRows::NumberOfHistory() {
  runtime::Supervisor::HistoryPointer history = model_.supervisor_->history();
  key_.clear();
  runtime::Supervisor::AddTo(history, &key_);
  return tables_->histories.NumberOf(KeyOfWords(key_), [&] { return std::move(history); });
}

void CardRows::WriteGlobals(const std::vector<GlobalWrite>& writes, Row* row) {
  std::vector<int64_t> words = tables_->globals[GlobalsNumber(*row)];
  // What is behind the globals stays there.
  for (const GlobalWrite& write : writes) {
    const int64_t missing = int64_t{write.slot} + 1 - words.front();
    if (missing > 0) {
      words.insert(EndOfGlobals(words), static_cast<size_t>(missing), 0);
      words.front() += missing;
    }
    words[write.slot + 1] = write.value;
  }
  while (words.front() > 0 && words[static_cast<size_t>(words.front())] == 0) {
    words.erase(EndOfGlobals(words) - 1);
    --words.front();
  }
  row->parts[thread_count()] = NumberOfWords(std::move(words));
}

std::vector<CardRows::GlobalWrite> CardRows::Differences(uint32_t before, uint32_t after,
                                                         bool* others) const {
  const std::vector<int64_t>& one = tables_->globals[before];
  const std::vector<int64_t>& two = tables_->globals[after];
  const auto value = [](const std::vector<int64_t>& words, uint32_t slot) {
    return slot < words.front() ? words[slot + 1] : 0;
  };
  std::vector<GlobalWrite> writes;
  for (uint32_t slot = 0; slot < std::max(one.front(), two.front()); ++slot) {
    if (value(one, slot) != value(two, slot)) writes.push_back({slot, value(two, slot)});
  }
  *others = !std::equal(EndOfGlobals(one), one.end(), EndOfGlobals(two), two.end());
  return writes;
}

void CardRows::SetBodyParts(const std::vector<std::pair<size_t, uint32_t>>& parts, Row* row) {
  std::vector<uint32_t> numbers = BodyOf(*row).parts;
  for (const auto& [part, number] : parts) numbers[part] = number;
  SetBody(NumberOfParts(std::move(numbers)), row);
}

void CardRows::SetProgress(Progress progress, Row* row) {
  key_.assign({progress.left, progress.served, progress.reached, progress.ended,
               static_cast<int64_t>(progress.fault)});
  for (const runtime::Owed& owed : progress.owed) key_.push_back(owed.pending ? owed.due_ns : -1);
  row->parts[thread_count() + 2] =
      tables_->progresses.NumberOf(KeyOfWords(key_), [&] { return std::move(progress); });
}

void CardRows::NoteStatement(size_t place, Row* row) {
  uint32_t& number = row->parts[thread_count() + 2];
  const size_t at = size_t{number} * thread_count() + place;
  if (at >= tables_->progresses_after.size()) tables_->progresses_after.resize(2 * at + 1, kNotYet);
  if (tables_->progresses_after[at] == kNotYet) {
    Progress progress = ProgressOf(*row);
    --progress.left;
    progress.served |= 1u << NumberOnCard(place);
    SetProgress(std::move(progress), row);
    tables_->progresses_after[at] = number;
  }
  number = tables_->progresses_after[at];
}

// --- Between rows and the card -------------------------------------------------------------------

void CardRows::LoadMachine(const Row& row) {
  vm::MachineState& machine = *machine_;
  const std::vector<int64_t>& globals = tables_->globals[GlobalsNumber(row)];
  std::span<const int64_t> words = std::span(globals).subspan(1);
  Fill(words.first(static_cast<size_t>(globals.front())), &machine.globals);
  words = words.subspan(static_cast<size_t>(globals.front()));
  uint32_t other_pages = machine.pages.used();
  while (!words.empty()) {
    const auto page = static_cast<size_t>(words[0]);
    const auto count = static_cast<size_t>(words[1]);
    Fill(words.subspan(2, count), &machine.pages.Use(page));
    other_pages &= ~(1u << page);
    words = words.subspan(2 + count);
  }
  for (size_t place = 0; place < thread_count(); ++place) {
    const Thread& thread = ThreadOf(row, place);
    machine.threads[static_cast<size_t>(numbers_[place])] = thread.state;
    Fill(thread.page, &machine.pages.Use(thread.state.page));
    other_pages &= ~(1u << thread.state.page);
  }
  for (; other_pages != 0; other_pages &= other_pages - 1) {
    machine.pages.Use(static_cast<size_t>(std::countr_zero(other_pages))).fill(0);
  }
  machine.cycle = CycleOf(row);
  machine.executed = 0;
  card_.machine().Restore(machine);
  model_.supervisor_->PutBack(HistoryOf(row));
  model_.held_ = nullptr;
}

void CardRows::Load(const Row& row) {
  LoadMachine(row);
  const Body& body = BodyOf(row);
  for (size_t part = 0; part < body.parts.size(); ++part) {
    PutPart(part, body.parts);
  }
  card_.RestoreBody(body_);
}

CardModel::State CardRows::StateFor(const Row& row) const {
  const Progress& progress = ProgressOf(row);
  CardModel::State state;
  state.left = progress.left;
  state.served = progress.served;
  state.reached = progress.reached;
  state.ended = progress.ended;
  state.finished = row.finished;
  state.owed = progress.owed;
  state.fault = faults_[row.fault];
  return state;
}

CardRows::Row CardRows::RowOfCard(const CardModel::State& state) {
  const auto& threads = card_.machine().state().threads;
  const auto bound = std::ranges::count_if(
      threads, [](const ThreadState& each) { return each.run != vm::ThreadRun::kUnbound; });
  if (static_cast<size_t>(bound) != thread_count()) exact_ = false;
  Row row;
  for (size_t place = 0; place < thread_count(); ++place) {
    row.parts[place] = NumberOfThread(place);
  }
  row.parts[thread_count()] = NumberOfGlobals();
  SetBody(NumberOfBody(), &row);
  row.history = NumberOfHistory();
  row.finished = state.finished;
  if (state.fault) {
    row.fault = static_cast<uint32_t>(faults_.size());
    faults_.push_back(state.fault);
  }
  SetProgress({state.left, state.served, state.reached, state.ended, state.fault.kind, state.owed},
              &row);
  return row;
}

CardModel::State CardRows::Program(const Row& row) {
  LoadMachine(row);
  CardModel::State state;
  state.variables.Pack(*machine_);
  state.threads = machine_->threads;
  return state;
}

CardModel::State CardRows::Whole(const Row& row) {
  Load(row);
  CardModel::State state = StateFor(row);
  state.choices = ChoicesOf(row);
  model_.Save(&state);
  return state;
}

StateKey CardRows::KeyOf(const Row& row, uint32_t number) const {
  return KeyOfWords(std::span(row.parts).first(part_count()), number);
}

// --- What can come next --------------------------------------------------------------------------

int64_t CardRows::ValueOf(const Row& row, uint32_t slot) const {
  const std::vector<int64_t>& globals = tables_->globals[GlobalsNumber(row)];
  return static_cast<int64_t>(slot) < globals.front() ? globals[slot + 1] : 0;
}

bool CardRows::CanContinue(const Row& row, size_t place) const {
  const Position& position = PositionOf(row, place);
  if (!position.running || position.wake_cycle > CycleOf(row)) return false;
  if (!position.waiting) return true;
  const ThreadState& thread = ThreadOf(row, place).state;
  const vm::SlotAddress& slot = thread.wait_slot;
  int64_t raw = 0;
  if (slot.global) {
    raw = ValueOf(row, slot.id);
  } else {
    for (size_t other = 0; other < thread_count(); ++other) {
      const Thread& holder = ThreadOf(row, other);
      if (holder.state.page == slot.page && slot.id < holder.page.size()) {
        raw = holder.page[slot.id];
      }
    }
  }
  if (slot.type != vm::DataType::kDouble) raw = static_cast<int32_t>(raw);
  return raw == thread.wait_value;
}

uint32_t CardRows::Runnable(const Row& row) const {
  uint32_t runnable = 0;
  for (size_t place = 0; place < thread_count(); ++place) {
    if (CanContinue(row, place)) runnable |= 1u << numbers_[place];
  }
  return runnable;
}

bool CardRows::SomeoneFinishes(const Row& row) const {
  for (size_t place = 0; place < thread_count(); ++place) {
    const Position& position = PositionOf(row, place);
    const bool slept = position.wake_cycle != 0 || position.waiting;
    if (position.at_end && slept && CanContinue(row, place)) return true;
  }
  return false;
}

uint32_t CardRows::ChoicesOf(const Row& row) const {
  const Progress& progress = ProgressOf(row);
  if (progress.ended || row.finished) return 0;
  const uint32_t runnable = Runnable(row);
  const uint32_t unserved = runnable & ~progress.served;
  const uint32_t candidates = std::popcount(unserved) >= progress.left ? unserved : runnable;
  uint32_t choices = 0;
  for (size_t i = 0; i < places_.size(); ++i) {
    if ((candidates >> numbers_[places_[i]] & 1) != 0) choices |= 1u << i;
  }
  return choices;
}

bool CardRows::MayEndCycle(const Row& row) const {
  const Progress& progress = ProgressOf(row);
  const uint32_t choices = ChoicesOf(row);
  for (size_t i = 0; i < places_.size(); ++i) {
    const bool can_run = (choices >> i & 1) != 0;
    if (can_run && (progress.served >> numbers_[places_[i]] & 1) == 0) return false;
  }
  return true;
}

}  // namespace oncard::explore
