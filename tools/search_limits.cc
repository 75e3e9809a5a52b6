#include "tools/search_limits.h"

#include <algorithm>
#include <optional>

#include "tools/memory_use.h"

namespace oncard::tools {
namespace {

/// How often the memory is looked at: a search takes up to half a gigabyte in a second.
constexpr std::chrono::milliseconds kMemoryLook{100};
constexpr int64_t kMiB = int64_t{1} << 20;
/// The search ends so much of the time limit before it: then a failure is made simpler, for so long
/// at most, and what is left of the search is saved.
constexpr double kReserved = 0.06;

int64_t MemoryLimit(int64_t memory_mib, int searches) {
  if (memory_mib > 0) return memory_mib * kMiB;
  const std::optional<int64_t> left = MemoryLeft();
  return left ? MemoryInUse() + *left / 2 / searches : INT64_MAX;
}

}  // namespace

SearchLimits::SearchLimits(double seconds, int64_t memory_mib, int searches,
                           explore::SearchProgress* progress)
    : progress_(progress),
      memory_(MemoryLimit(memory_mib, searches)),
      given_(seconds),
      searched_(given_ * (1 - kReserved)) {}

void SearchLimits::End(std::atomic<bool>* why) {
  *why = true;
  progress_->interrupted = true;
  progress_->stop = true;
}

bool SearchLimits::Look() {
  const std::chrono::duration<double> passed = Clock::now() - start_;
  if (progress_->out_of_time) {
    if (passed < given_) return true;
    progress_->hurried = true;
    return false;
  }
  if (given_.count() > 0 && passed >= searched_) {
    End(&progress_->out_of_time);
  } else if (!progress_->out_of_memory && MemoryInUse() > memory_) {
    End(&progress_->out_of_memory);
  }
  return true;
}

std::chrono::duration<double> SearchLimits::Next() const {
  if (given_.count() == 0) return kMemoryLook;
  const auto end = progress_->out_of_time ? given_ : searched_;
  const std::chrono::duration<double> left = start_ + end - Clock::now();
  return std::min<std::chrono::duration<double>>(left, kMemoryLook);
}

}  // namespace oncard::tools
