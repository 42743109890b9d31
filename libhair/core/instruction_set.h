#pragma once

#include <string_view>
#include <vector>

namespace hair {

/// The instruction set that kernels use now. They are compiled for several, and run with the best
/// that the CPU has. Names are Google Highway's: "AVX3" (AVX-512), "AVX2", "NEON", "SCALAR" (any
/// CPU: SSE2 on x86-64).
std::string_view instructionSet();

/// Those that kernels are compiled for and this CPU has, best first.
std::vector<std::string_view> instructionSets();

/// While it lives, kernels use no better instruction set than this. Throws Error for one that is
/// not among instructionSets(). For tests and benchmarks: make it while no other thread computes.
class InstructionSetLimit {
 public:
  /// `name`: one of instructionSets().
  explicit InstructionSetLimit(std::string_view name);
  ~InstructionSetLimit();
  InstructionSetLimit(const InstructionSetLimit&) = delete;
  InstructionSetLimit& operator=(const InstructionSetLimit&) = delete;

 private:
  long long before_;
};

}  // namespace hair
