#include "base/text_pieces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace oncard {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

std::vector<std::string> PiecesOf(const TextSource& source) {
  std::vector<std::string> pieces;
  source([&](std::string_view piece) { pieces.emplace_back(piece); });
  return pieces;
}

TEST(TextPieces, TextInMemoryIsOnePiece) {
  EXPECT_THAT(PiecesOf(SourceOf("a\nb")), ElementsAre("a\nb"));
}

TEST(TextPieces, BufferPassesOnWhatIsLeftAtItsEnd) {
  EXPECT_THAT(PiecesOf([](const TextSink& sink) {
                TextBuffer text(sink);
                text += "a";
                text += "bc";
              }),
              ElementsAre("abc"));
  EXPECT_THAT(PiecesOf([](const TextSink& sink) { const TextBuffer text(sink); }), IsEmpty());
}

TEST(TextPieces, BufferPassesOnAPieceAsSoonAsItIsLarge) {
  const std::string half(TextBuffer::kPieceSize / 2, 'x');
  EXPECT_THAT(PiecesOf([&](const TextSink& sink) {
                TextBuffer text(sink);
                for (const char* end : {"1", "2", "3"}) text += half + end;
              }),
              ElementsAre(half + "1" + half + "2", half + "3"));
}

}  // namespace
}  // namespace oncard
