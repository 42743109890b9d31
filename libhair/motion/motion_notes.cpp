#include <cmath>
#include <set>

#include <libhair/core/error.h>
#include <libhair/motion/body.h>
#include <libhair/motion/motion.h>
#include <libhair/motion/person_frame.h>

namespace hair {
namespace {

/// To three digits.
double rounded(double value) {
  if (!(value > 0) || !std::isfinite(value)) return value;
  const double step = std::pow(10.0, std::floor(std::log10(value)) - 2);
  return std::round(value / step) * step;
}

}  // namespace

std::string Motion::person() const {
  const float height = statureOf(body_->skeleton, body_->map);
  std::string words = height > 0 ? text(rounded(height), " m tall") : "of unknown height";
  if (source_)
    words += text(", ", rounded(source_->scale), " m per unit, ", clipUpText(source_->up), " up");
  return words +
         text(", head joint ", body_->skeleton.names[static_cast<std::size_t>(body_->map.head)]);
}

std::vector<std::string> Motion::notes() const {
  std::vector<std::string> lines;
  if (!source_) return lines;
  lines.push_back("person " + person());
  const float height = statureOf(body_->skeleton, body_->map);
  if (height > 0 && (height < 0.5f || height > 3.0f))
    lines.push_back(text("a person ", rounded(height),
                         " m tall, as the scale asks; by the bones it is ",
                         rounded(source_->recognisedScale), " m per unit"));
  if (!body_->map.complete()) lines.push_back(body_->notes.front());
  for (const std::string& note : source_->notes) lines.push_back(note);
  std::string repairs;
  const auto add = [&](const std::string& what) {
    repairs += (repairs.empty() ? "" : ", ") + what;
  };
  if (droppedFrames_ > 0)
    add(text(droppedFrames_, " frames of a calibration pose at the start dropped"));
  if (!flips_.empty()) {
    std::set<std::size_t> joints;
    for (const Flip& flip : flips_) joints.insert(flip.joint);
    add(text(flips_.size(), flips_.size() == 1 ? " flip" : " flips", " of ", joints.size(),
             joints.size() == 1 ? " joint" : " joints", " interpolated"));
  }
  if (!repairs.empty()) lines.push_back("repaired: " + repairs);
  return lines;
}

std::vector<std::string> Motion::details() const {
  std::vector<std::string> lines;
  for (std::size_t i = body_->map.complete() ? 0 : 1; i < body_->notes.size(); ++i)
    lines.push_back(body_->notes[i]);
  for (const Flip& flip : flips_)
    lines.push_back(text(body_->skeleton.names[flip.joint], " flips by ", flip.degrees,
                         " degrees at frame ", flip.frame, "; ", flip.frames,
                         flip.frames == 1 ? " frame" : " frames", " interpolated"));
  return lines;
}

}  // namespace hair
