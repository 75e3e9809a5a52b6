// Long texts, made and passed on piece by piece, so that they never are in memory as a whole.
// Tested by tests/base/text_pieces_test.cc.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <utility>

namespace oncard {

/// Takes the next piece of a text.
using TextSink = std::function<void(std::string_view piece)>;
/// Gives all pieces of a text to a sink, in order; every time the same ones.
using TextSource = std::function<void(const TextSink& sink)>;

/// A text in one piece. It must outlive the source.
inline TextSource SourceOf(std::string_view text) {
  return [text](const TextSink& sink) { sink(text); };
}

/// Collects the small parts of a text and passes them on in larger pieces, the last one at its own
/// end. The sink must outlive it.
class TextBuffer {
 public:
  static constexpr size_t kPieceSize = size_t{64} << 10;

  explicit TextBuffer(const TextSink& sink) : sink_(sink) {}
  TextBuffer(const TextBuffer&) = delete;
  TextBuffer& operator=(const TextBuffer&) = delete;
  ~TextBuffer() {
    if (!piece_.empty()) sink_(piece_);
  }

  TextBuffer& operator+=(std::string_view part) {
    piece_ += part;
    if (piece_.size() >= kPieceSize) {
      sink_(piece_);
      piece_.clear();
    }
    return *this;
  }

 private:
  const TextSink& sink_;
  std::string piece_;
};

}  // namespace oncard
