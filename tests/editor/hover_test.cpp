// Hover texts: numbers compared with calculation by hand and with the generator's results.

#include "client.h"
#include "patterns.h"
#include "run_tool.h"

namespace robcogen::test::hover_test {
namespace {

std::string hover(Client& client, const std::string& uri, const std::string& word) {
  const Json answer = client.ask_at("textDocument/hover", uri, word);
  return answer.is_null() ? "" : answer.at("contents").at("value").get<std::string>();
}

const std::string kArm = R"(Robot Arm {
    RobotBase base { children { upper via shoulder } }
    link upper {
        id = 1
        inertia_params {
            mass = 2.0  CoM = (0.5, 0.0, 0.0)
            Ix = 0.1  Iy = 0.8  Iz = 0.9  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
        }
        children { lower via elbow }
        frames { tip { translation = (1.0, 0.0, 0.0)  rotation = (0.0, 0.0, PI/4.0) } }
    }
    link lower {
        id = 2
        inertia_params {
            mass = 1.0  CoM = (0.0, 0.0, half[0.25])
            Ix = 0.1  Iy = 0.1  Iz = 0.05  Ixy = 0.0  Ixz = 0.0  Iyz = 0.0
        }
        children {}
    }
    r_joint shoulder {
        ref_frame { translation = (0.0, 0.0, 1.0)  rotation = (-PI/2.0, 0.0, 0.0) }
        limits { position = (-1.5, 2.0)  effort = 30.0 }
    }
    p_joint elbow { ref_frame { translation = (0.7/2.0, length[0.3], 0.0)  rotation = (0.0, 0.3, 0.0) } }
}
)";

TEST(Hover, SaysWhatElementsAre) {
  Client client;
  const std::string uri = "file:///arm.kindsl";
  client.open(uri, kArm);
  // By the parallel-axis theorem: 0.8 - 2 * 0.25 = 0.3, 0.9 - 0.5 = 0.4. The lower link is at (0.35 + 0.25 sin 0.3,
  // 0.3, 0.25 cos 0.3) in the upper link, whose y axis points down and whose z axis is the y axis of the base.
  EXPECT_EQ(
      hover(client, uri, "link up|per"),
      "**link** `upper`, child of `base` via `shoulder`\n\n- mass 2 kg\n- centre of mass (0.5, 0, 0) m, in the link "
      "frame\n- principal moments (0.1, 0.3, 0.4) kg m², about the centre of mass\n- with all it carries: 3 kg, centre "
      "of mass (0.474627, 0.0796114, 0.9) m in the base at q = 0");
  // The rotation of -90 degrees about x maps z to y.
  EXPECT_EQ(
      hover(client, uri, "r_joint should|er"),
      "**revolute joint** `shoulder`, from `base` to `upper`\n\n- axis (0, 1, 0) in the base at q = 0\n- limits -1.5 "
      "to "
      "2 rad\n- effort up to 30 N m");
  EXPECT_EQ(
      hover(client, uri, "t|ip {"),
      "**frame** `tip` of link `upper`\n\n- origin (1, 0, 1) m in the base at q = 0\n- rotation (-90, 0, 45)° about x, "
      "y', z''");
  EXPECT_EQ(
      hover(client, uri, "len|gth"), "**parameter** `length`, a length (m)\n\n- default 0.3\n- 1 use in this document");
  EXPECT_EQ(
      hover(client, uri, "ha|lf"),
      "**parameter** `half`, a mass or drive property\n\n- default 0.25\n- 1 use in this document");
  EXPECT_EQ(hover(client, uri, "-PI/|2.0"), "`-PI/2.0` is -90°, -1.5707963267948966 rad");
  EXPECT_EQ(hover(client, uri, "0.7/|2.0"), "`0.7/2.0` is 0.35");
  EXPECT_EQ(hover(client, uri, "0.|3, 0.0) }"), "`0.3` is 17.1887°, 0.3 rad");
  EXPECT_EQ(hover(client, uri, "inertia_par|ams"), "");
}

// The crank is at 90 degrees; there the rod, which is as long as the distance between the pivots, is level.
TEST(Hover, IsOfWhereLoopsAreAssembled) {
  Client client;
  const std::string uri = "file:///bars.kindsl";
  client.open(uri, R"(Robot Bars {
    RobotBase base { children { crank via turn  rocker via swing } }
    link crank { id = 1  children { rod via elbow } }
    link rod { id = 2  children {}  frames { end { translation = (0.5, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } } }
    link rocker { id = 3  children {}  frames { pin { translation = (0.2, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } } }
    r_joint turn { ref_frame { translation = (0.0, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } assembled = PI/2.0 }
    r_joint elbow { ref_frame { translation = (0.2, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } assembled = -PI/2.0 }
    r_joint swing { ref_frame { translation = (0.5, 0.0, 0.0)  rotation = (0.0, 0.0, 0.0) } assembled = PI/2.0 }
    loops { bar { frames = end ~ pin  type = hinge } }
    independent { turn }
}
)");
  EXPECT_EQ(
      hover(client, uri, "en|d {"),
      "**frame** `end` of link `rod`\n\n- origin (0.5, 0.2, 0) m in the base, where loops are assembled\n- rotation "
      "(0, 0, 0)° about x, y', z''");
}

TEST(Hover, OfAPartIsThatOfAnInstance) {
  Client client;
  const std::string uri = "file:///robot.kindsl";
  client.open(
      uri,
      "Part Leg(thigh) {\n root hip via HAA\n link hip { inertia_params { mass = 3.0 CoM = (thigh, 0.0, 0.0) Ix = 1.0 "
      "Iy "
      "= 2.0 Iz = 2.0 Ixy = 0.0 Ixz = 0.0 Iyz = 0.0 } children {} }\n r_joint HAA { ref_frame { translation = (0.0, "
      "0.0, "
      "0.0) rotation = (0.0, PI/2.0, 0.0) } }\n}\nRobot R { RobotBase b { children { Leg left(thigh = 0.4) } } }\n");
  const std::string text = hover(client, uri, "link h|ip");
  EXPECT_NE(text.find("`left_hip`"), std::string::npos) << text;
  EXPECT_NE(text.find("centre of mass (0.4, 0, 0) m"), std::string::npos) << text;
  EXPECT_NE(hover(client, uri, "r_joint HA|A").find("axis (1, 0, 0)"), std::string::npos);
}

// Compares the origins of all frames and the centre of mass with the generator's programs, run by the interpreter.
TEST(Hover, HasTheNumbersOfTheGenerator) {
  for (const char* name : {"tree5", "iiwa14", "gripper", "scara", "wrist"}) {
    Client client;
    const std::string uri = file_uri(robot(name)), text = contents(robot(name));
    client.open(uri, text);
    const std::string list = "file:///list.dtdsl";
    const std::optional<Match> robot_name = first_match(text, R"((?:^|\n)Robot (\w+))");
    ASSERT_TRUE(robot_name);
    const std::string owner = (*robot_name)[1];
    std::vector<std::string> links;
    for (const Match& link : all_matches(text, R"((?:^|\n)\s*(?:link|RobotBase) +(\w+))")) links.push_back(link[1]);
    ASSERT_GT(links.size(), 3U);
    for (std::size_t i = 1; i < links.size(); i += 4) {
      client.open(list, "Robot " + owner + "\nFrames { fr_" + links[i] + " }\nTransforms {}\n");
      const std::string shown = hover(client, list, "fr_" + links[i]);
      const std::optional<Match> numbers = first_match(shown, R"(origin \((.*), (.*), (.*)\) m)");
      ASSERT_TRUE(numbers) << name << " " << links[i] << shown;
      const std::string function = "transforms.homogeneous.fr_" + links[0] + "_X_fr_" + links[i];
      const std::string none = std::string("{\"q\": [") + [&] {
        std::string zeros;
        const Outcome ops = run_tool("ops --algorithms inverse_dynamics '" + robot(name).string() + "'");
        const std::optional<Match> count = first_match(ops.output, R"(: (\d+) )");
        EXPECT_TRUE(count);
        for (int k = 0; count && k < std::stoi((*count)[1]); ++k) zeros += k == 0 ? "0" : ", 0";
        return zeros;
      }() + "]}";
      const Outcome run = run_tool("eval --quiet '" + robot(name).string() + "' " + function, none);
      ASSERT_EQ(run.status, 0) << run.errors;
      const Json pose = Json::parse(run.output).at("X");
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(std::stod((*numbers)[k + 1]), pose[k][3].get<double>(), 1e-5) << name << " " << links[i];
    }
  }
}

// 2 m along x of a frame that is turned by 90 degrees about z is 2 m along y; there, a turn about the new x axis.
TEST(Hover, OfFramesOfMotions) {
  Client client;
  const std::string uri = "file:///crane.motdsl", list = "file:///crane.dtdsl";
  client.open(
      uri,
      "Model crane\nConvention = local\n\npost -> jib : rotz(swing + PI/2.0)\njib -> trolley : trx(2.0 + reach[0.5])\n"
      "trolley -> hook : trz(-rope) rotx(PI/6.0)\nother -> alone : try(1.0)\n");
  client.open(list, "Model crane\nFrames { post, hook }\nTransforms { post <- hook }\n");
  EXPECT_EQ(hover(client, uri, "po|st ->"), "**frame** `post` of model `crane`");
  const std::string hook =
      "**frame** `hook` of model `crane`\n\n- origin (0, 2.5, 0) m in `post` where variables are zero\n- rotation (0, "
      "30, 90)° about x, y', z''\n- from `post`: rotz(swing + PI/2.0) trx(2.0 + reach) trz(-rope) rotx(PI/6.0)";
  EXPECT_EQ(hover(client, uri, "ho|ok :"), hook);
  EXPECT_EQ(hover(client, list, "ho|ok }"), hook);
  EXPECT_EQ(
      hover(client, uri, "alo|ne"),
      "**frame** `alone` of model `crane`\n\n- origin (0, 1, 0) m in `other` where variables are zero\n- rotation (0, "
      "0, 0)° about x, y', z''\n- from `other`: try(1.0)");
  EXPECT_EQ(
      hover(client, uri, "rea|ch["), "**parameter** `reach`, a length (m)\n\n- default 0.5\n- 1 use in this document");
  EXPECT_EQ(hover(client, uri, "trz(-ro|pe)"), "**variable** `rope`\n\n- 1 use in this document");
  // The same motion as transforms in the other direction, from the moved frame.
  const std::string other = "file:///crane.ctdsl";
  client.open(
      other, "Model crane\nMovedFramePos = left\n{jib}_X_{post} = Rz(swing + PI/2.0)\n{trolley}_X_{jib} = Tx(2.5)\n");
  const std::string of_transforms = hover(client, other, "{pos|t}");
  EXPECT_NE(of_transforms.find("- origin (0, 0, 0) m in `jib` where variables"), std::string::npos) << of_transforms;
  EXPECT_NE(of_transforms.find("- rotation (0, 0, -90)°"), std::string::npos) << of_transforms;
}

}  // namespace
}  // namespace robcogen::test::hover_test
