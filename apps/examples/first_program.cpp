// The program of README.md: a built-in hairstyle on the built-in dance, two seconds of it.
//
//   example_first_program
#include <cstdio>

#include <libhair/hair.h>

int main() {
  const auto head = std::make_shared<hair::MeshSdf>(hair::builtinHead().mesh);
  const hair::Motion dance = hair::Motion::dance();
  hair::BodyPose pose = dance.pose(0);
  hair::Simulation dancer(hair::makeGroom(hair::styleSettings(hair::Style::Smooth), *head), {},
                          {pose.worldFromHead, pose.capsules}, head);

  for (int f = 1; f <= 120; ++f) {
    dance.pose(f / 60.0, pose);
    dancer.step({pose.worldFromHead, pose.capsules}, 1.0f / 60);
    // To draw: dancer.strands(), and dancer.colours(), an sRGB colour a point.
  }
  std::printf("%zu points after %.1f s\n", dancer.strands().pointCount(), dancer.time());
}
