#include "bundler/launch/host/import_check.hpp"

#include <gtest/gtest.h>

namespace ros2wasm {
namespace {

constexpr const char* kScript = "lib/demo/run";

class ImportCheckTest : public ::testing::Test {
 protected:
  void module(const std::string& path, const std::string& text) {
    workspace_[std::string(kPythonModules) + "/" + path] = text;
  }

  std::vector<std::string> messages(const std::string& script) {
    workspace_[kScript] = script;
    report_ = check_imports(kScript, {.workspace = workspace_,
                                      .channels = channels_,
                                      .wheels = wheels_,
                                      .interfaces = interfaces_,
                                      .channel_names = names_,
                                      .distro = "jazzy"});
    std::vector<std::string> result;
    for (const Diagnostic& one : report_.missing)
      result.push_back((one.severity == Severity::kError ? "" : "warning: ") + one.message);
    return result;
  }

  using Lines = std::vector<std::string>;
  PythonFiles workspace_;
  PythonFiles wheels_;
  PythonFiles channels_{
      {std::string(kPythonModules) + "/rclpy/__init__.py", "import nowhere"},
      {std::string(kPythonModules) + "/rclpy/node.py", ""},
      {std::string(kPythonModules) + "/numpy/__init__.py", ""},
      {std::string(kPythonModules) + "/numpy/core.cpython-312-wasm32-emscripten.so", ""}};
  std::map<std::string, std::string> interfaces_{{"std_msgs/msg/String", ""},
                                                 {"demo/srv/Trigger", ""}};
  std::vector<std::string> names_{"opencv", "ros-jazzy-rclpy"};
  ImportReport report_;
};

TEST_F(ImportCheckTest, WheelsAreFollowedForWhatAProgramNeeds) {
  const std::string modules = std::string(kPythonModules) + "/";
  wheels_ = {{modules + "parts/__init__.py", "from .arm import Arm\n"},
             {modules + "parts/arm.py",
              "import math, numpy\nimport gone\ntry:\n  import faster\nexcept ImportError: pass\n"},
             {modules + "parts/unused.py", "import never\n"}};
  EXPECT_EQ(messages("import parts\n"), (Lines{"no package of the site has the module `gone`"}));
  EXPECT_EQ(report_.missing[0].span->file, modules + "parts/arm.py");
  EXPECT_EQ(report_.missing[0].span->line, 2U);
  EXPECT_EQ(report_.compiled, std::set<std::string>{"numpy"});
  EXPECT_EQ(messages("try:\n  import parts.arm\nexcept ImportError: pass\n"), Lines{});
  EXPECT_EQ(messages("import parts.leg\n"),
            (Lines{"no package of the site has the module `gone`", "`parts.leg` is not there"}));
}

TEST_F(ImportCheckTest, WhatFailsWhenItIsUsedIsAWarning) {
  wheels_ = {{std::string(kPythonModules) + "/parts.py", "import subprocess\n"}};
  EXPECT_EQ(
      messages("import subprocess, http, socket as s, parts\nfrom urllib import request, parse\n"
               "import http.server\nfrom multiprocessing.pool import ThreadPool\n"
               "def f():\n  from ctypes import CDLL\n"),
      (Lines{"warning: `subprocess` can be imported, but does not work in a site",
             "warning: `socket` can be imported, but does not work in a site",
             "warning: `urllib.request` can be imported, but does not work in a site",
             "warning: `http.server` can be imported, but does not work in a site",
             "warning: `multiprocessing` can be imported, but does not work in a site",
             "warning: `ctypes` can be imported, but does not work in a site"}));
  EXPECT_EQ(report_.missing[0].code, "R2W0526");
  EXPECT_EQ(report_.missing[0].span->line, 1U);
  EXPECT_EQ(report_.missing[0].why.size(), 2U);
  EXPECT_EQ(messages("import http, urllib.parse, socketio_like\n"),
            (Lines{"no package of the site has the module `socketio_like`"}));
}

TEST_F(ImportCheckTest, FollowsTheModulesOfTheWorkspaceOnly) {
  module("demo/__init__.py", "");
  module("demo/talker.py",
         "import rclpy, json\nfrom rclpy.node import Node\nfrom .parts import part\n"
         "from . import other\nfrom std_msgs.msg import String\n"
         "from demo.srv import Trigger, Trigger_Request\n");
  module("demo/parts.py", "import not_there\n");
  module("demo/other.py", "from .. import away\nimport demo.gone\n");
  module("demo/unused.py", "import never\n");
  EXPECT_EQ(messages("from demo.talker import main"),
            (Lines{"no package of the site has the module `not_there`",
                   "`..` leads out of the package", "`demo.gone` is not there"}));
  EXPECT_EQ(report_.missing[0].span->file, std::string(kPythonModules) + "/demo/parts.py");
  EXPECT_EQ(report_.missing[0].span->line, 1U);
  EXPECT_EQ(
      report_.missing[0].why[0],
      "no channel has `ros-jazzy-not-there` or `not_there`, nor has the workspace a module of "
      "that name");
}

TEST_F(ImportCheckTest, WhatCanBeDoneWithoutIsAWarning) {
  EXPECT_EQ(messages("try:\n  import cv2\nexcept ImportError:\n  cv2 = None\n"),
            Lines{"warning: no package of the site has the module `cv2`"});
  EXPECT_EQ(report_.missing[0].why.size(), 2U);
}

TEST_F(ImportCheckTest, KnowsPartsOfPackagesAndOfPython) {
  EXPECT_EQ(messages("import rclpy.lifecycle\nimport sqlite3\nfrom std_msgs.msg import Strin\n"
                     "from std_msgs.srv import A\n"),
            (Lines{"`rclpy.lifecycle` is not there", "`sqlite3` is not there in a site",
                   "`std_msgs.msg` has no `Strin`", "`std_msgs.srv` is not there"}));
}

TEST_F(ImportCheckTest, KnowsTheModulesOfDefinitions) {
  EXPECT_EQ(messages("from std_msgs.msg._string import String\n"
                     "from demo.srv._trigger import Trigger, Trigger_Request\n"
                     "import std_msgs.msg._string\n"),
            Lines());
  EXPECT_EQ(messages("from std_msgs.msg._string import Strin\n"),
            Lines{"`std_msgs.msg._string` has no `Strin`"});
}

TEST_F(ImportCheckTest, KnowsModulesAndPackagesBesideTheScript) {
  workspace_["lib/demo/helpers/__init__.py"] = "";
  workspace_["lib/demo/helpers/motion.py"] = "from . import angles\nfrom .gone import x\n";
  workspace_["lib/demo/helpers/angles.py"] = "import never\n";
  workspace_["lib/demo/plain/inner.py"] = "";
  EXPECT_EQ(messages("import helpers.motion\nfrom plain import inner\nimport plain.inner\n"
                     "import helpers.none\n"),
            (Lines{"no package of the site has the module `never`", "`helpers.gone` is not there",
                   "`helpers.none` is not there"}));
  EXPECT_EQ(messages("from . import helpers\n"), Lines{"`.` leads out of the package"});
}

TEST_F(ImportCheckTest, ProgramsOfChannelsGetTheirCompiledModules) {
  const std::string clouds = std::string(kPythonModules) + "/clouds/";
  channels_[clouds + "__init__.py"] = "from numpy import array\n";
  channels_[clouds + "main.py"] = "";
  channels_["lib/clouds/run"] = "from clouds.main import main\n";
  const ImportReport report = check_imports("lib/clouds/run", {.workspace = workspace_,
                                                               .channels = channels_,
                                                               .wheels = wheels_,
                                                               .interfaces = interfaces_,
                                                               .channel_names = names_,
                                                               .distro = "jazzy"});
  EXPECT_EQ(report.compiled, std::set<std::string>{"numpy"});
  EXPECT_TRUE(report.missing.empty());
}

TEST_F(ImportCheckTest, CompiledModulesAreTold) {
  module("demo/__init__.py", "def f():\n  from numpy import array\n");
  EXPECT_EQ(messages("import demo\nimport beside"),
            Lines{"no package of the site has the module `beside`"});
  EXPECT_EQ(report_.compiled, std::set<std::string>{"numpy"});
  workspace_["lib/demo/beside.py"] = "";
  EXPECT_EQ(messages("import beside"), Lines());
  EXPECT_TRUE(report_.compiled.empty());
  EXPECT_EQ(compiled_modules(channels_), std::set<std::string>{"numpy"});
  const std::string clouds = std::string(kPythonModules) + "/clouds/";
  channels_[clouds + "__init__.py"] = "";
  channels_[clouds + "reading.py"] = "from . import arrays\nimport gone\n";
  channels_[clouds + "arrays.py"] = "import numpy as np\n";
  EXPECT_EQ(messages("from clouds import reading"), Lines());
  EXPECT_EQ(report_.compiled, std::set<std::string>{"numpy"});
  channels_[clouds + "arrays.py"] = "try:\n  import numpy\nexcept ImportError:\n  pass\n";
  EXPECT_EQ(messages("from clouds import reading"), Lines());
  EXPECT_TRUE(report_.compiled.empty());
}

}  // namespace
}  // namespace ros2wasm
