// The program of README.md: a built-in hairstyle on the built-in dance, two seconds of it.
//
//   example_first_program
#include <cstdio>

#include <libhair/model/styles.h>
#include <libhair/motion/motion.h>
#include <libhair/simulation/frame.h>

int main() {
  const hair::MeshSdf head(hair::builtinHead().mesh);
  const hair::Groom groom = hair::makeGroom(hair::styleSettings(hair::Style::Smooth), head);
  const hair::Motion dance = hair::Motion::dance();
  const hair::FrameSettings settings;
  hair::BodyPose pose = dance.pose(0);
  hair::Hair dancer(groom, settings, {pose.worldFromHead, pose.capsules}, &head);

  hair::FrameProfile profile{};
  for (int f = 1; f <= 120; ++f) {
    dance.pose(f / 60.0, pose);
    hair::frame({pose.worldFromHead, pose.capsules}, settings, 1.0f / 60, dancer, profile);
    // To draw: dancer.strands(), and dancer.colours, an sRGB colour a point.
  }
  std::printf("%zu points after %.1f s\n", dancer.strands().pointCount(), dancer.time);
}
