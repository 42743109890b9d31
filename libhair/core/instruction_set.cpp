#include <libhair/core/instruction_set.h>

#include <hwy/highway.h>

#include <libhair/core/error.h>

namespace hair {

namespace {

// Targets are bits, better ones lower.
template <class Visit>
void forTargets(Visit&& visit) {
  const auto there = static_cast<std::uint64_t>(HWY_TARGETS & hwy::SupportedTargets());
  for (std::uint64_t rest = there; rest != 0; rest &= rest - 1)
    visit(static_cast<std::int64_t>(rest & (~rest + 1)));
}

}  // namespace

std::string_view instructionSet() {
  return instructionSets().front();
}

std::vector<std::string_view> instructionSets() {
  std::vector<std::string_view> names;
  forTargets([&](std::int64_t target) { names.emplace_back(hwy::TargetName(target)); });
  return names;
}

InstructionSetLimit::InstructionSetLimit(std::string_view name) : before_(hwy::SupportedTargets()) {
  std::int64_t allowed = 0, all = 0;
  forTargets([&](std::int64_t target) {
    all |= target;
    if (hwy::TargetName(target) == name) allowed = target;
  });
  require(allowed != 0, "instruction set: ", name, " is not among those of this CPU (",
          hwy::TargetName(all & -all), " and below)");
  // Better ones have lower bits.
  hwy::SetSupportedTargetsForTest(before_ & ~(allowed - 1));
}

InstructionSetLimit::~InstructionSetLimit() {
  hwy::SetSupportedTargetsForTest(before_);
}

}  // namespace hair
