#include "import/mjcf/elements.h"

#include "support/words.h"

namespace robcogen::import::from_mjcf {

namespace {

struct Row {
  const char* kind;
  const char* read;
  const char* without_effect;
  const char* children;
};

constexpr const char* kTurn = " quat axisangle xyaxes zaxis euler";

// `+` at the end of `read` stands for the five orientations.
constexpr Row kRows[] = {
    {"mujoco", "model", "",
     "compiler option size statistic visual default extension asset worldbody deformable contact tendon equality "
     "actuator sensor custom keyframe"},
    {"compiler",
     "alignfree angle assetdir autolimits balanceinertia boundinertia boundmass coordinate eulerseq exactmeshinertia "
     "inertiafromgeom inertiagrouprange meshdir settotalmass strippath",
     "conflict convexhull discardvisual fitaabb fusestatic saveinertial texturedir usethread", "lengthrange"},
    {"option", "density gravity viscosity wind",
     "actuatorgroupdisable apirate ccd_iterations ccd_tolerance collision cone impratio integrator iterations jacobian "
     "ls_iterations ls_tolerance magnetic mpr_iterations mpr_tolerance noslip_iterations noslip_tolerance o_friction "
     "o_margin o_solimp o_solref sdf_initpoints sdf_iterations sleep_tolerance solver timestep tolerance",
     "flag"},
    {"flag", "constraint damper equality frictionloss gravity passive spring",
     "actuation autoreset clampctrl contact diagexact energy eulerdamp filterparent fwdinv invdiscrete island limit "
     "midphase multiccd nativeccd override refsafe sensor sensornoise sleep warmstart",
     ""},
    {"default", "class", "",
     "default mesh material joint geom site camera light pair equality tendon general motor position velocity "
     "intvelocity orientation pid damper cylinder muscle adhesion dcmotor"},
    {"default/equality", "active", "solimp solref", ""},
    {"asset", "", "", "mesh hfield skin texture material model"},
    {"mesh", "builtin class face file inertia name refpos refquat scale vertex",
     "content_type material maxhullvert normal params smoothnormal texcoord", "plugin"},
    {"worldbody", "", "", ""},
    {"body", "childclass gravcomp mocap name pos+", "class simple sleep user", ""},
    {"frame", "childclass name pos+", "", ""},
    {"replicate", "childclass count euler offset sep", "", ""},
    {"inertial", "diaginertia fullinertia mass pos+", "", ""},
    {"freejoint", "align name", "group", ""},
    {"joint",
     "actuatorfrclimited actuatorfrcrange armature axis class damping frictionloss limited name pos range ref "
     "springdamper springref stiffness type",
     "actuatorgravcomp group margin solimpfriction solimplimit solreffriction solreflimit user", ""},
    {"geom", "class density fromto group mass mesh name pos shellinertia size type+",
     "adhesion conaffinity condim contype fitscale fluidcoef fluidshape friction gap hfield margin material priority "
     "rgba solimp solmix solref surfacevel user",
     "plugin"},
    {"site", "class fromto name pos type+", "group material rgba size user", ""},
    {"equality", "", "", "connect weld joint tendon flex flexvert flexstrain distance"},
    {"equality/connect", "active anchor body1 body2 class name site1 site2", "solimp solref", ""},
    {"equality/weld", "active anchor body1 body2 class name relpose site1 site2 torquescale", "solimp solref", ""},
    {"equality/joint", "active class joint1 joint2 name polycoef", "solimp solref", ""},
    {"equality/tendon", "active class name polycoef tendon1 tendon2", "solimp solref", ""},
    {"tendons", "", "", "spatial fixed"},
    {"tendon", "armature class damping frictionloss name springlength stiffness",
     "actuatorfrclimited actuatorfrcrange group limited margin material range rgba solimpfriction solimplimit "
     "solreffriction solreflimit user width",
     "site geom pulley joint"},
    {"actuators", "", "",
     "general motor position velocity intvelocity orientation pid damper cylinder muscle adhesion dcmotor plugin"},
    {"actuator", "armature class damping gear joint jointinparent tendon",
     "actdim actearly actlimited actrange area bias biasprm biastype body cogging controller cranklength cranksite "
     "ctrllimited ctrlrange dampratio delay diameter dynprm dyntype ffrange force forcelimited forcerange fpmax fvmax "
     "gain gainprm gaintype group imax inductance inheritrange input instance interp ki kp kv lengthrange lmax lmin "
     "lugre motorconst name nominal nsample plugin posrange range refsite resistance saturation scale site slewmax "
     "slidersite tausmooth thermal timeconst user velrange vmax",
     "config"},
    {"contact", "", "", "pair exclude"},
    {"deformable", "", "", "flex skin"},
};

xml::KnownElements table() {
  xml::KnownElements result;
  for (const Row& row : kRows) {
    std::string read = row.read;
    if (read.ends_with('+')) read = read.substr(0, read.size() - 1) + kTurn;
    result[row.kind] = {words(read), words(row.without_effect), words(row.children), {}};
  }
  return result;
}

}  // namespace

const KnownElement* known_element(const std::string& kind) {
  static const xml::KnownElements known = table();
  return xml::find(known, kind);
}

}  // namespace robcogen::import::from_mjcf
