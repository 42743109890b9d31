#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include <apps/common/scene_view.h>
#include <apps/dance/history.h>
#include <libhair/model/styles.h>
#include <libhair/repulsion/repulsion.h>
#include <libhair/shade/kajiya_kay.h>
#include <libhair/shadow/density_map.h>

namespace hair {

/// How the window shows self-shadowing.
enum class ShadowView : std::uint8_t { Off, On, SideBySide };

/// All that the panel sets: plain values, grouped by what has to be done when they change.
struct Controls {
  bool paused = false;
  float speed = 1;  ///< simulated seconds a real one, [0.05, 3]

  /// Which hair: growing it takes a moment, so it is done when asked for.
  struct Growth {
    bool fromFile = false;  ///< the hair that the command line names, instead of a style
    Style style = Style::Smooth;
    int strands = 0;  ///< drawn; 0: the style's, or all of the file's
    bool operator==(const Growth&) const = default;
  } growth;

  struct Shadow {
    ShadowView view = ShadowView::On;
    int cells = 128;
    Deposit deposit = Deposit::Columns;
    Filter filter = Filter::Centred;
    bool operator==(const Shadow&) const = default;
  } shadow;
  bool headShadowsHair = true;

  KajiyaKaySettings look;
  bool ownLook = true;  ///< the one that comes with the hair

  struct SelfCollision {
    bool on = true;
    RepulsionKind kind = RepulsionKind::Gradient;
    float strength = RepulsionSettings{}.strength;  ///< m/s²
    bool operator==(const SelfCollision&) const = default;
  } selfCollision;

  struct Breeze {
    float speed = 0;           ///< m/s
    float towards = 90;        ///< degrees about +Y, 0: along +Z
    float up = 0;              ///< degrees
    float gust = Wind{}.gust;  ///< swing as a share of the speed
    bool operator==(const Breeze&) const = default;
  } wind;

  draw::HairPrimitive primitive = draw::HairPrimitive::Lines;
  int samples = 4;  ///< of multisampling
  bool follow = true;
  bool ground = true;
  InternalsShown internals;
  bool editMesh = false;  ///< the hair mesh: the dancer stands still, and its vertices are dragged
  bool internalsOnTop = true;
};

/// What the panel asks for once.
struct Requests {
  bool step = false, reset = false;
  bool grow = false;                ///< hair as Controls::growth says
  bool undo = false, redo = false;  ///< of the hair mesh's edits
};

/// What the panel shows of the simulation.
struct Readout {
  std::string hairFile;  ///< name of the command line's hair; empty: none
  std::size_t strands = 0, points = 0, guides = 0, guidePoints = 0;
  std::uint32_t saturatedCells = 0;
  bool enlarged = false;      ///< cells of a map, as the hair is larger than the map
  float cellSize = 0;         ///< metres
  double time = 0;            ///< of the motion, seconds
  double duration = 0;        ///< 0: nobody moves
  double droppedSeconds = 0;  ///< that the simulation did not keep up with
  double picturesPerSecond = 0;
  double simulatedPerSecond = 0;  ///< seconds a real one
  bool softwareDrawing = false;
  Controls::Growth grown;          ///< the hair there is
  std::string failure;             ///< why the last growing failed; or empty
  std::vector<std::string> notes;  ///< on loading
  bool hasMesh = false;            ///< the hair was grown in a hair mesh
  bool canUndo = false, canRedo = false;
  std::string editFailure;                ///< why the last edit was taken back; or empty
  double editMilliseconds = 0;            ///< that the last edit took, all of it
  std::uint32_t placementIterations = 0;  ///< of conjugate gradients, for interior vertices
  History history;

  // What the panel's last drawing says of itself.
  bool timesShown = false;
  float panelWidth = 0;  ///< that it takes from the picture, screen units
};

}  // namespace hair
