"""The layer rules find what is planted, and nothing in the repository."""
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from tests.tools import layers

FILES = {
    "runtime/site/contract/session.ts": "export interface Session {}\n",
    "runtime/site/bus/bus.ts": "import type { Session } from '../contract/session.ts';\n",
    "runtime/site/session/launcher.ts": "import { bus } from '../bus/bus.ts';\n",
    "runtime/site/page/names.ts": "import { read } from '../decode/reader.ts';\n",
    "runtime/site/decode/reader.ts": "export const read = 1;\n",
    "runtime/site/decode/ros_names.ts": "export const joinName = 1;\n",
    "runtime/site/bag/player.ts": "import { read } from '../decode/reader.ts';\n",
    "runtime/site/ui/page.tsx": "import { open } from '../session/launcher.ts';\n",
    "runtime/protocol/generated/constants.ts": "export const one = 1;\n",
    "bundler/plan.cpp": "#include \"workspace_schema/schema/manifest.hpp\"\n",
    "workspace_schema/schema/manifest.hpp": "#include <string>\n",
    "cli/main.cpp": "#include \"bundler/plan.hpp\"\n",
    "runtime/packages/client/rclcpp/package.xml": "<package/>",
    "runtime/packages/client/rclcpp/src/node.cpp": "#include \"rclcpp/node.hpp\"\n",
}
# path -> (what is planted there, what the message must say)
PLANTED = {
    "a type from a higher floor": (
        "runtime/site/bus/bus.ts", "import type { L } from '../session/launcher.ts';", "on a higher floor"),
    "a floor that uses the page": ("runtime/site/bus/bus.ts", "import { p } from '../ui/page.tsx';", "beside them"),
    "messages in the bus": ("runtime/site/bus/bus.ts", "import { read } from '../decode/reader.ts';", "no messages"),
    "the page looks into the bus": ("runtime/site/ui/page.tsx", "import { bus } from '../bus/bus.ts';", "sees only"),
    "a bag that knows the page": ("runtime/site/bag/player.ts", "import { p } from '../ui/page.tsx';", "sees only"),
    "a file that is imported when it is needed": (
        "runtime/site/bus/bus.ts", "const late = await import('../session/launcher.ts');", "on a higher floor"),
    "a file of the tests": ("runtime/site/bus/bus.ts", "import { x } from '../../../tests/x.ts';", "nothing of the"),
    "a circle of two": ("runtime/site/decode/reader.ts", "import { j } from './ros_names.ts';", "import each other"),
    "an unknown floor": ("runtime/site/attic/old.ts", "", "no such floor"),
    "the schema uses the bundler": (
        "workspace_schema/schema/manifest.hpp", "#include \"bundler/plan.hpp\"", "is below bundler"),
    "a step uses a later one": ("bundler/io/files.cpp", "#include \"bundler/emit/page.hpp\"", "io is below emit"),
    "a step uses what joins the steps": (
        "bundler/io/files.cpp", "#include \"bundler/plan.hpp\"", "is below what joins"),
    "what is pure uses what reaches the disk": (
        "bundler/launch/scope.hpp", "#include \"bundler/launch/host/world.hpp\"", "does not know host"),
    "the base of the schema uses the manifest": (
        "workspace_schema/base/json.hpp", "#include \"workspace_schema/schema/manifest.hpp\"", "does not know schema"),
    "a part without a place": ("workspace_schema/attic/old.hpp", "", "no such part"),
    "a folder of the bundler without a place": ("bundler/attic/old.cpp", "", "no such folder"),
    "the bundler uses the site": ("bundler/plan.cpp", "#include \"runtime/site/x.hpp\"", "nothing of the site"),
    "a package uses the bundler": (
        "runtime/packages/client/rclcpp/src/node.cpp", "#include \"bundler/plan.hpp\"", "packages know"),
}


class LayersTest(unittest.TestCase):
    def faults(self, changed: dict[str, str]) -> list[str]:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder).resolve()
            for name, text in {**FILES, **changed}.items():
                file = root / name
                file.parent.mkdir(parents=True, exist_ok=True)
                file.write_text(text, encoding="utf-8")
            with mock.patch.object(layers, "ROOT", root):
                return layers.violations()

    def test_a_tree_that_points_down_is_fine(self) -> None:
        self.assertEqual(self.faults({}), [])

    def test_what_is_planted_is_found(self) -> None:
        for what, (path, line, says) in PLANTED.items():
            with self.subTest(what):
                other = {"runtime/site/decode/ros_names.ts": "import { read } from './reader.ts';\n"} \
                    if "circle" in what else {}
                found = self.faults({path: f"{FILES.get(path, '')}{line}\n", **other})
                self.assertTrue(found)
                self.assertIn(says, found[0])

    def test_names_of_ros_are_not_messages(self) -> None:
        line = "import { joinName } from '../decode/ros_names.ts';\n"
        self.assertEqual(self.faults({"runtime/site/bus/bus.ts": line}), [])


if __name__ == "__main__":
    unittest.main()
