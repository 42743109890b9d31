// Moves guides of one's own, past a collider of one's own: the stage `guides` alone, with neither
// hairstyle nor head.
//
//   example_step_my_guides
//
// Look at: guides are a plain array of points; what carries them (the head), what is in their way
// (a ball) and what blows at them is handed over each frame; links keep their lengths and points
// stay out of the ball. The pictures are the fringe seen from its side at four times: the ball
// comes from the left, goes through it and is gone.
#include <cstdio>
#include <string>
#include <vector>

#include <libhair/guides/guide_strands.h>

namespace {

void draw(const hair::GuideStrands& guides, const hair::Capsule& ball, float seconds) {
  constexpr int kRows = 13, kColumns = 52;
  std::vector<std::string> rows(kRows, std::string(kColumns, ' '));
  for (int r = 0; r < kRows; ++r)
    for (int c = 0; c < kColumns; ++c) {
      const glm::vec3 p(0.01f * (static_cast<float>(c) - 26), -0.02f * static_cast<float>(r), 0);
      if (glm::distance(p, ball.a) < ball.radius) rows[r][c] = '.';
    }
  for (std::size_t g = 0; g < guides.guideCount(); ++g)
    for (std::uint32_t i = 0; i < guides.pointsPerGuide(); ++i) {
      const glm::vec3 p = guides.point(g, i);
      const int r = static_cast<int>(-p.y / 0.02f + 0.5f),
                c = static_cast<int>(p.x / 0.01f + 26.5f);
      if (r >= 0 && r < kRows && c >= 0 && c < kColumns) rows[r][c] = 'o';
    }
  std::printf("%.2f s\n", seconds);
  for (const std::string& row : rows) std::printf("  %s\n", row.c_str());
}

}  // namespace

int main() {
  // Twenty guides of twelve points, 22 cm long, hanging in a row across the ball's way.
  hair::Groom groom;
  groom.pointsPerGuide = 12;
  for (int g = 0; g < 20; ++g)
    for (int i = 0; i < 12; ++i)
      groom.guidePoints.emplace_back(0, -0.02f * static_cast<float>(i),
                                     0.003f * static_cast<float>(g - 10));
  const hair::GuideSettings settings;
  hair::GuideStrands guides(groom, settings);
  hair::GuideWorkspace workspace;

  hair::GuideStats worst;
  hair::Capsule before{{-0.3f, -0.15f, 0}, {-0.3f, -0.15f, 0}, 0.06f}, ball = before;
  for (int frame = 0; frame <= 60; ++frame) {
    ball.a.x = ball.b.x = -0.3f + 0.012f * static_cast<float>(frame);
    hair::GuideMotion motion;  // the head stands still: the identity
    motion.capsules = {&ball, 1};
    motion.capsulesBefore = {&before, 1};
    hair::stepGuides(motion, settings, 1.0f / 60, workspace, guides);
    before = ball;
    const auto stats = hair::measureGuides(guides, settings, {&ball, 1}, nullptr);
    worst.stretchMax = std::max(worst.stretchMax, stats.stretchMax);
    worst.penetrationMax = std::max(worst.penetrationMax, stats.penetrationMax);
    if (frame % 16 == 10) draw(guides, ball, static_cast<float>(frame) / 60);
  }
  std::printf("most stretch %.4f %%, deepest point in the ball %.2f mm\n", 100 * worst.stretchMax,
              1e3f * worst.penetrationMax);
  const bool kept = worst.stretchMax < 1e-3f && worst.penetrationMax < 1e-3f;
  std::puts(kept ? "lengths and collider were kept" : "NOT kept");
  return kept ? 0 : 1;
}
