// What a frame, a groom and the shadows are told: plain fields, whose defaults are the library's.
#include <pybind11/operators.h>

#include <libhair/core/error.h>
#include <libhair/measure/shadow/error_model.h>
#include <libhair/simulation/frame.h>
#include <libhair/wisps/bind.h>

#include "fields.h"
#include "topics.h"

namespace hair::python {

namespace {

void bindLight(py::module_& m) {
  py::class_<Light>(m, "Light",
                    "A light: what casts shadows and what shading is told. It does not change.")
      .def_static(
          "parallel",
          [](glm::vec3 direction, glm::vec3 colour) {
            makeLightSpace(direction);  // throws where it is no direction
            return Light::parallel(direction, colour);
          },
          py::arg("direction"), py::arg("colour") = glm::vec3(1),
          "At infinity, as the sun. direction: the way light travels. colour: linear RGB.")
      .def_static(
          "point", &Light::point, py::arg("position"), py::arg("colour") = glm::vec3(1),
          "At a point (metres), as a lamp. colour: linear RGB of what arrives at the pivot.")
      .def_readonly("kind", &Light::kind, "\"parallel\" or \"point\".")
      .def_readonly("direction", &Light::direction, "Of parallel light, the way it travels.")
      .def_readonly("position", &Light::position, "Of a light at a point, metres.")
      .def_readonly("colour", &Light::colour, "Linear RGB.")
      .def(
          "__eq__", [](const Light& a, const Light& b) { return a == b; }, py::is_operator(),
          py::arg("other"), "The same in every number.")
      .def(py::pickle(
          [](const Light& l) { return py::make_tuple(l.kind, l.direction, l.position, l.colour); },
          [](const py::tuple& state) {
            Light light;
            light.kind = state[0].cast<Light::Kind>();
            light.direction = state[1].cast<glm::vec3>();
            light.position = state[2].cast<glm::vec3>();
            light.colour = state[3].cast<glm::vec3>();
            return light;
          }))
      .def("__repr__", [](const Light& l) {
        const bool parallel = l.kind == Light::Kind::Parallel;
        const glm::vec3 v = parallel ? l.direction : l.position;
        return text("Light.", parallel ? "parallel" : "point", "((", v.x, ", ", v.y, ", ", v.z,
                    "), (", l.colour.x, ", ", l.colour.y, ", ", l.colour.z, "))");
      });
}

void bindMotionSettings(py::module_& m) {
  Fields<GuideSettings>(m, "GuideSettings",
                        "How guide strands move; the defaults are a human hair's.")
      .field("linear_density", &GuideSettings::linearDensity, "kg/m.")
      .field("bending_stiffness", &GuideSettings::bendingStiffness,
             "N m² (E I) at the root; 0: a string, which only hangs.")
      .field("tip_stiffness", &GuideSettings::tipStiffness,
             "Fraction of it left at the tip, (0, 1].")
      .field("bend_damping", &GuideSettings::bendDamping, "Seconds, >= 0.")
      .field("air_drag", &GuideSettings::airDrag, "1/s: how speed relative to the air decays.")
      .field("carried_air", &GuideSettings::carriedAir,
             "How much of the head's motion the air in its hair has, [0, 1].")
      .field("friction", &GuideSettings::friction, "Coulomb's coefficient on colliders, >= 0.")
      .field("skin", &GuideSettings::skin, "Metres that guide points keep from colliders, >= 0.")
      .field("gravity", &GuideSettings::gravity, "(x, y, z), m/s².")
      .field("substep", &GuideSettings::substep, "Seconds, the longest step inside a frame.")
      .field("link_solver", &GuideSettings::linkSolver,
             "\"direct\" (no stretch) or \"relaxation\".")
      .field("iterations", &GuideSettings::iterations, "Of the link solver a substep, 1 to 32.");

  Fields<RepulsionSettings>(m, "RepulsionSettings",
                            "Self-collision: hair denser than it was groomed spreads out.")
      .field("kind", &RepulsionSettings::kind, "\"gradient\" or \"cell centre\".")
      .field("cell_size", &RepulsionSettings::cellSize, "Of the map of density, metres.")
      .field("cells", &RepulsionSettings::cells, "Of that map along each axis.")
      .field("strand_stride", &RepulsionSettings::strandStride,
             "Every so many drawn strands are counted, for all.")
      .field("threshold", &RepulsionSettings::threshold, "Metres of hair per m³ that never push.")
      .field("tolerance", &RepulsionSettings::tolerance,
             "Nor does less than the groom's own density times this, >= 1.")
      .field("strength", &RepulsionSettings::strength,
             "m/s² where density is twice what it may be.")
      .field("limit", &RepulsionSettings::limit, "m/s², the most.")
      .field("interval", &RepulsionSettings::interval, "Seconds between two looks, (0, 1].");

  Fields<Wind>(m, "Wind", "Moving air: a steady flow, and gusts that travel with it.")
      .field("velocity", &Wind::velocity, "(x, y, z), m/s; zero: still air.")
      .field("gust", &Wind::gust, "Swing of the speed as a fraction of it, [0, 1].")
      .field("gust_length", &Wind::gustLength, "Metres from gust to gust.")
      .field("shelter", &Wind::shelter,
             "How well hair keeps the wind off hair behind it, metres, [0, 1]; real hair: 1e-4.");

  Fields<WispSettings>(m, "WispSettings", "How drawn strands are kept out of colliders.")
      .field("avoid_colliders", &WispSettings::avoidColliders, "Whether they are.")
      .field("clearance", &WispSettings::clearance,
             "Metres that drawn points keep from colliders, [0, 0.1).")
      .field("blend_points", &WispSettings::blendPoints,
             "Points above the first hit over which a strand changes over.");
}

void bindShadowSettings(py::module_& m) {
  Fields<DensityGridSettings>(m, "DensityGridSettings", "A grid of hair density.")
      .field("cells", &DensityGridSettings::cells, "Along each axis, 2 to 1024.")
      .field("cell_size", &DensityGridSettings::cellSize, "Metres.")
      .field("deposit", &DensityGridSettings::deposit,
             "How strands are written: \"columns\", \"points\" or \"segments\".");
  Fields<DensityMapSettings>(m, "DensityMapSettings", "The light-oriented density map.")
      .field("cells", &DensityMapSettings::cells, "Along each axis, 2 to 1024.")
      .field("cell_size", &DensityMapSettings::cellSize, "Metres.")
      .field("deposit", &DensityMapSettings::deposit,
             "How strands are written: \"columns\", \"points\" or \"segments\".")
      .field("filter", &DensityMapSettings::filter,
             "How it is read: \"centred\", \"footprint\", \"paper\" or \"none\".")
      .field("footprint", &DensityMapSettings::footprint,
             "Radius of the disc that filter \"footprint\" averages over, metres.")
      .field("point_extinction", &DensityMapSettings::pointExtinction,
             "Extinction of a point, 1/metre, deposit \"points\" only; 0: chosen.");
  Fields<ShadowMapSettings>(m, "ShadowMapSettings", "Shadow map with percentage-closer filtering.")
      .field("pixel_size", &ShadowMapSettings::pixelSize, "Metres.")
      .field("filter_radius", &ShadowMapSettings::filterRadius, "Metres, >= 0.")
      .field("bias", &ShadowMapSettings::bias, "Metres towards the light, >= 0.");
  Fields<OpacityMapSettings>(m, "OpacityMapSettings", "Opacity shadow maps.")
      .field("pixel_size", &OpacityMapSettings::pixelSize, "Metres.")
      .field("slices", &OpacityMapSettings::slices, "1 to 1024.")
      .field("extinction", &OpacityMapSettings::extinction, "\"unbiased\" or \"published\".")
      .field("filter", &OpacityMapSettings::filter, "\"linear\" or \"nearest\".");
  Fields<DeepOpacityMapSettings>(m, "DeepOpacityMapSettings", "Deep opacity maps.")
      .field("pixel_size", &DeepOpacityMapSettings::pixelSize, "Metres.")
      .field("layers", &DeepOpacityMapSettings::layers, "1 to 255.")
      .field("growth", &DeepOpacityMapSettings::growth,
             "Of layer sizes: \"constant\", \"linear\", \"doubling\" or \"fibonacci\".")
      .field("beyond", &DeepOpacityMapSettings::beyond,
             "Hair behind the last layer: \"ignored\", \"in last layer\" or \"larger layers\".")
      .field("depth", &DeepOpacityMapSettings::depth, "Metres, of all layers together.")
      .field("depth_bits", &DeepOpacityMapSettings::depthBits, "8, 16 or 32.")
      .field("extinction", &DeepOpacityMapSettings::extinction, "\"unbiased\" or \"published\".")
      .field("filter", &DeepOpacityMapSettings::filter, "\"linear\" or \"nearest\".");
  Fields<DensityClusteringSettings>(m, "DensityClusteringSettings", "Density clustering.")
      .field("pixel_size", &DensityClusteringSettings::pixelSize, "Metres.")
      .field("clusters", &DensityClusteringSettings::clusters, "1 to 64.")
      .field("iterations", &DensityClusteringSettings::iterations, "Of k-means, >= 1.")
      .field("start", &DensityClusteringSettings::start, "\"uniform\" or \"towards light\".")
      .field("extinction", &DensityClusteringSettings::extinction, "\"unbiased\" or \"published\".")
      .field("filter", &DensityClusteringSettings::filter, "\"linear\" or \"nearest\".");
  Fields<DeepShadowMapSettings>(m, "DeepShadowMapSettings", "Deep shadow maps.")
      .field("pixel_size", &DeepShadowMapSettings::pixelSize, "Metres.")
      .field("tolerance", &DeepShadowMapSettings::tolerance, "Of transmittance, >= 0.")
      .field("extinction", &DeepShadowMapSettings::extinction, "\"unbiased\" or \"published\".")
      .field("filter", &DeepShadowMapSettings::filter, "\"linear\" or \"nearest\".");
  Fields<PilotSettings>(m, "PilotSettings", "How many exact points a choice of shadows looks at.")
      .field("points", &PilotSettings::points, ">= 8.")
      .field("least_rays", &PilotSettings::leastRays, "A point, >= 8.")
      .field("most_rays", &PilotSettings::mostRays, ">= least_rays.")
      .field("noise", &PilotSettings::noise, "That may be left of the truth, root mean square.")
      .field("seed", &PilotSettings::seed, "Another: other points and rays.");
}

void bindLooks(py::module_& m) {
  Fields<KajiyaKaySettings>(m, "KajiyaKaySettings", "How hair looks. Colours are linear RGB.")
      .field("root_colour", &KajiyaKaySettings::rootColour, "Linear RGB.")
      .field("tip_colour", &KajiyaKaySettings::tipColour, "Linear RGB.")
      .field("variation", &KajiyaKaySettings::variation,
             "Strands are up to this part lighter or darker, [0, 1].")
      .field("ambient", &KajiyaKaySettings::ambient, "Of the colour, lit from everywhere.")
      .field("diffuse", &KajiyaKaySettings::diffuse, "Of the colour, by the angle to the light.")
      .field("specular", &KajiyaKaySettings::specular, "Of white, at the first highlight's peak.")
      .field("exponent", &KajiyaKaySettings::exponent, "Of the first highlight.")
      .field("second_specular", &KajiyaKaySettings::secondSpecular,
             "A second highlight in the hair's own colour; 0: none.")
      .field("second_exponent", &KajiyaKaySettings::secondExponent, "Of the second highlight.")
      .field("first_shift", &KajiyaKaySettings::firstShift, "Radians towards the tip.")
      .field("second_shift", &KajiyaKaySettings::secondShift, "Radians towards the tip.")
      .type()
      .def_static("plain", &KajiyaKaySettings::plain,
                  "The model of the paper alone: one highlight, unmoved, all strands alike.");

  Fields<FrameSettings>(m, "FrameSettings",
                        "What a frame computes; a stage that is off costs nothing.")
      .field("guides", &FrameSettings::guides, "GuideSettings.")
      .field("self_collision", &FrameSettings::selfCollision, "Whether hair pushes hair.")
      .field("repulsion", &FrameSettings::repulsion, "RepulsionSettings.")
      .field("wind", &FrameSettings::wind, "Wind.")
      .field(
          "lights", [](const FrameSettings& s) { return py::tuple(py::cast(s.lights)); },
          [](FrameSettings& s, std::vector<Light> lights) { s.lights = std::move(lights); },
          "Light objects, a tuple; any sequence may be given. None: hair in its ambient colour.")
      .field("shadow", &FrameSettings::shadow, "Whether there are shadows.")
      .field("map", &FrameSettings::map, "DensityMapSettings of every light's map (fit_map).")
      .field("body_shadow", &FrameSettings::bodyShadow,
             "Whether head and body cast shadows on hair.")
      .field("shade", &FrameSettings::shade, "Whether radiance or colours are made.")
      .field("encode", &FrameSettings::encode, "Whether colours (sRGB bytes) are made.")
      .field("radiance", &FrameSettings::radiance, "Whether linear radiance is kept.")
      .field("appearance", &FrameSettings::appearance, "How hair looks: KajiyaKaySettings.")
      .field("eye", &FrameSettings::eye, "Where the picture is taken from, (x, y, z) metres.");
}

void bindGroomSettings(py::module_& m) {
  Fields<Fibre>(m, "Fibre", "What a drawn strand stands for: so many hairs.")
      .field("width", &Fibre::width, "Of one hair, metres.")
      .field("opacity", &Fibre::opacity, "Of one hair to the light, (0, 1].")
      .field("hairs_per_strand", &Fibre::hairsPerStrand, "Hairs that one strand stands for, >= 1.");
  Fields<BindSettings>(m, "BindSettings", "How strands are bound to guides (bind_groom).")
      .field("guides", &BindSettings::guides, "Chosen among the strands.")
      .field("points_per_guide", &BindSettings::pointsPerGuide, "2 to 64.")
      .field("shape_weight", &BindSettings::shapeWeight,
             "How much a difference of tips counts beside one of roots, >= 0.");
  Fields<Parting>(m, "Parting", "Where hair parts on the built-in head.")
      .field("x", &Parting::x, "Right or left of the nose, metres.")
      .field("whorl_z", &Parting::whorlZ, "Where the line ends, metres.");

  Fields<StyleSettings> s(
      m, "StyleSettings",
      "How a hairstyle is grown on the built-in head; style_settings has them.");
  s.field("strands", &StyleSettings::strands, "Drawn, >= wisps.");
  s.field("points", &StyleSettings::points, "A drawn strand, >= 2.");
  s.field("wisps", &StyleSettings::wisps, "Of three guides each, >= 1.");
  s.field("points_per_guide", &StyleSettings::pointsPerGuide, ">= 3.");
  s.field("seed", &StyleSettings::seed, "Another: other random numbers.");
  s.field("hairs", &StyleSettings::hairs, "That the drawn strands stand for together.");
  s.field("cut_height_front", &StyleSettings::cutHeightFront,
          "Beside the face, metres, head space.");
  s.field("cut_height_back", &StyleSettings::cutHeightBack, "Metres, head space.");
  s.field("min_length", &StyleSettings::minLength, "Metres.");
  s.field("max_length", &StyleSettings::maxLength, "Metres.");
  s.field("length_variation", &StyleSettings::lengthVariation, "Share, from wisp to wisp.");
  s.field("parting", &StyleSettings::parting, "Parting.");
  s.field("parting_jitter", &StyleSettings::partingJitter,
          "Metres from it where wisps fall to either side.");
  s.field("part_at_shoulders", &StyleSettings::partAtShoulders,
          "0: hair lies on them, 1: it falls before or behind them.");
  s.field("volume", &StyleSettings::volume, "Metres of the uppermost hair from the head.");
  s.field("root_lift", &StyleSettings::rootLift, "0: flat, 1: at 45 degrees.");
  s.field("waviness", &StyleSettings::waviness, "Radians that wisps swing.");
  s.field("turn_in", &StyleSettings::turnIn, "How much the tips turn to the neck, 0 to 1.");
  s.field("clump", &StyleSettings::clump, "How far strands of a wisp come together, 0 to 1.");
  s.field("clump_by", &StyleSettings::clumpBy, "By which share of the length they have.");
  s.field("spread", &StyleSettings::spread,
          "What is left at the tip of a root's place in its wisp, 0 to 1.");
  s.field("curl_radius", &StyleSettings::curlRadius, "Metres; 0: no curls.");
  s.field("curl_pitch", &StyleSettings::curlPitch, "Metres along the guide, a turn.");
  s.field("curl_jitter", &StyleSettings::curlJitter, "Radians of phase between strands.");
  s.field("tip_share", &StyleSettings::tipShare, "Of strands whose tips deviate.");
  s.field("tip_deviation", &StyleSettings::tipDeviation, "Metres.");
  s.field("whole_share", &StyleSettings::wholeShare, "Of strands that deviate as a whole.");
  s.field("whole_deviation", &StyleSettings::wholeDeviation, "Metres.");
}

}  // namespace

void bindSettings(py::module_& m) {
  bindLight(m);
  bindMotionSettings(m);
  bindShadowSettings(m);
  bindLooks(m);
  bindGroomSettings(m);
}

}  // namespace hair::python
