// CMake as people write it: in one workspace, packages with habits that a native build takes, each with a program that says
// that it is there.
//
// Compatibility, works: CMakeLists.txt that ask for a newer CMake than the machine has (a warning, R2W0529), that call `project()`
// before `cmake_minimum_required()`, or whose own Find module finds nothing (only what links the library is skipped)
//
// Compatibility, works: packages without a package.xml, by the name in their CMakeLists.txt, and packages that depend on them
//
// Compatibility, works: C headers of messages (`geometry_msgs/msg/transform_stamped.h`), also of the package's own, in C and C++: structures, `__init`, `__fini`,
// `__create`, `__destroy`, `__copy`, `__are_equal`, lists and texts of rosidl_runtime_c
//
// Compatibility, works: libraries that CMakeLists.txt ask pkg-config for, as far as channels have them (`uuid`)
//
// Compatibility, cannot: libraries of the machine that builds (`/usr/lib`) -> R2W0519 or a warning that the program which links one
// is skipped; the channel's are found by their names
//
// Compatibility, cannot: type support of C messages (`ROSIDL_GET_MSG_TYPE_SUPPORT` in C) -> the linker (R2W0504), because sites have no rclc;
// publish the C++ message
import assert from 'node:assert/strict';
import { existsSync, globSync } from 'node:fs';
import { join } from 'node:path';
import { after, before, test } from 'node:test';
import { PackWorkspace } from '../support/pack_workspace.ts';

const HEAD = (name: string, more: string): string =>
  `<?xml version="1.0"?>
<package format="3">
  <name>${name}</name>
  <version>0.1.0</version>
  <description>A package of a test</description>
  <maintainer email="someone@example.org">Someone</maintainer>
  <license>Apache-2.0</license>
${more}
  <export><build_type>ament_cmake</build_type></export>
</package>
`;
const AMENT = '  <buildtool_depend>ament_cmake</buildtool_depend>';
const SAYS = (text: string): string => `#include <cstdio>\nint main() { std::puts("${text}"); }\n`;

const FILES: Readonly<Record<string, string>> = {
  // --- a newer CMake, in the package and in a folder of it
  'src/newer/package.xml': HEAD('newer', AMENT),
  'src/newer/CMakeLists.txt': `cmake_minimum_required(VERSION 99.1.2...99.4 FATAL_ERROR)
project(newer VERSION 2.1)
find_package(ament_cmake REQUIRED)
if(NOT CMAKE_SOURCE_DIR STREQUAL CMAKE_CURRENT_SOURCE_DIR OR NOT CMAKE_PROJECT_NAME STREQUAL "newer"
    OR NOT CMAKE_BINARY_DIR STREQUAL CMAKE_CURRENT_BINARY_DIR)  # older ways of CMake must not show
  message(FATAL_ERROR "not the topmost project: \${CMAKE_SOURCE_DIR} \${CMAKE_PROJECT_NAME} \${CMAKE_BINARY_DIR}")
endif()
file(WRITE "\${CMAKE_BINARY_DIR}/made.h" "#define MADE \\"made by \${PROJECT_VERSION}\\"\\n")
include_directories("\${CMAKE_CURRENT_BINARY_DIR}")
add_subdirectory(inner)
install(TARGETS newer DESTINATION lib/newer)
ament_package()
`,
  'src/newer/inner/CMakeLists.txt': `cmake_minimum_required(VERSION 99.3)
set(words newer older)
if("newer" IN_LIST words)
  add_executable(newer newer.cpp)
endif()
`,
  'src/newer/inner/newer.cpp': '#include <cstdio>\n#include "made.h"\nint main() { std::printf("%s of %s\\n", MADE, __FILE__); }\n',

  // --- without a package.xml, and who needs it; a folder for another machine
  'src/plain/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
# project(other)
project( plain_math  VERSION 1.2 LANGUAGES CXX)
add_library(plain_math STATIC plain_math.cpp)
target_include_directories(plain_math PUBLIC $<BUILD_INTERFACE:\${CMAKE_CURRENT_SOURCE_DIR}> $<INSTALL_INTERFACE:include>)
install(FILES plain_math.hpp DESTINATION include)
install(TARGETS plain_math EXPORT plain_math ARCHIVE DESTINATION lib)
install(EXPORT plain_math DESTINATION lib/cmake/plain_math FILE plain_math-config.cmake)
`,
  'src/plain/plain_math.hpp': '#pragma once\nint twice(int value);\n',
  'src/plain/plain_math.cpp': '#include "plain_math.hpp"\nint twice(int value) { return 2 * value; }\n',
  'src/a_user/package.xml': HEAD('a_user', `${AMENT}\n  <depend>plain_math</depend>`),
  'src/a_user/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(a_user)
find_package(ament_cmake REQUIRED)
find_package(plain_math REQUIRED)
add_executable(a_user a_user.cpp)
target_link_libraries(a_user plain_math)
install(TARGETS a_user DESTINATION lib/a_user)
ament_package()
`,
  'src/a_user/a_user.cpp': '#include <cstdio>\n#include "plain_math.hpp"\nint main() { std::printf("twice 21 is %d\\n", twice(21)); }\n',
  'src/a_user/vendored/CMakeLists.txt': 'cmake_minimum_required(VERSION 3.8)\nproject(vendored)\nmessage(FATAL_ERROR "it is a part of a_user")\n',
  'src/board/CMakeLists.txt': 'cmake_minimum_required(VERSION 3.8)\nproject(board_firmware C)\nmessage(FATAL_ERROR "set IDF_PATH first")\n',

  // --- C messages
  'src/in_c/package.xml': HEAD('in_c', `${AMENT}\n  <depend>geometry_msgs</depend>\n  <depend>sensor_msgs</depend>\n  <depend>std_srvs</depend>`),
  'src/in_c/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(in_c)
find_package(ament_cmake REQUIRED)
find_package(geometry_msgs REQUIRED)
find_package(sensor_msgs REQUIRED)
find_package(std_srvs REQUIRED)
add_executable(in_c in_c.c more.cpp)
ament_target_dependencies(in_c geometry_msgs sensor_msgs std_srvs)
install(TARGETS in_c DESTINATION lib/in_c)
ament_package()
`,
  'src/in_c/in_c.c': `#include <stdio.h>
#include "geometry_msgs/msg/transform_stamped.h"
#include <sensor_msgs/msg/joint_state.h>
#include "std_srvs/srv/set_bool.h"
#include "rosidl_runtime_c/string_functions.h"

void more(const geometry_msgs__msg__TransformStamped * transform);

int main(void)
{
  geometry_msgs__msg__TransformStamped * transform = geometry_msgs__msg__TransformStamped__create();
  rosidl_runtime_c__String__assign(&transform->child_frame_id, "gripper");
  transform->transform.translation.x = 1.5;
  sensor_msgs__msg__JointState state, copy;
  sensor_msgs__msg__JointState__init(&state);
  sensor_msgs__msg__JointState__init(&copy);
  rosidl_runtime_c__String__Sequence__init(&state.name, 2);
  rosidl_runtime_c__String__assign(&state.name.data[1], "elbow");
  rosidl_runtime_c__double__Sequence__init(&state.position, 2);
  state.position.data[1] = 0.25;
  sensor_msgs__msg__JointState__copy(&state, &copy);
  const bool equal = sensor_msgs__msg__JointState__are_equal(&state, &copy);
  copy.position.data[1] = 0.5;
  std_srvs__srv__SetBool_Request__Sequence requests;
  std_srvs__srv__SetBool_Request__Sequence__init(&requests, 3);
  printf("C: %s w=%.1f %s %.2f equal %d, then %d, %d requests\\n", transform->child_frame_id.data, transform->transform.rotation.w,
    copy.name.data[1].data, state.position.data[1], equal, sensor_msgs__msg__JointState__are_equal(&state, &copy), (int)requests.size);
  more(transform);
  std_srvs__srv__SetBool_Request__Sequence__fini(&requests);
  sensor_msgs__msg__JointState__fini(&state);
  sensor_msgs__msg__JointState__fini(&copy);
  geometry_msgs__msg__TransformStamped__destroy(transform);
  return 0;
}
`,
  'src/in_c/more.cpp': `#include <cstdio>
#include "geometry_msgs/msg/transform_stamped.h"
#include "geometry_msgs/msg/transform_stamped.hpp"
extern "C" void more(const geometry_msgs__msg__TransformStamped * transform) {
  geometry_msgs::msg::TransformStamped same;
  same.transform.translation.x = transform->transform.translation.x;
  std::printf("C++: %.1f\\n", same.transform.translation.x);
}
`,

  // --- C messages of the package itself
  'src/own_c/package.xml': HEAD('own_c', `${AMENT}
  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n  <depend>geometry_msgs</depend>
  <exec_depend>rosidl_default_runtime</exec_depend>\n  <member_of_group>rosidl_interface_packages</member_of_group>`),
  'src/own_c/msg/Wheel.msg': 'string name\nfloat64 radius 0.25\n',
  'src/own_c/msg/WheelList.msg': 'Wheel[] wheels\ngeometry_msgs/Vector3 offset\nint32 MOST=4\n',
  'src/own_c/srv/SetWheel.srv': 'Wheel wheel\n---\nbool good\n',
  'src/own_c/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(own_c)
find_package(ament_cmake REQUIRED)
find_package(geometry_msgs REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(\${PROJECT_NAME} "msg/Wheel.msg" "msg/WheelList.msg" "srv/SetWheel.srv" DEPENDENCIES geometry_msgs)
add_executable(wheels own_c.c)
rosidl_get_typesupport_target(c_typesupport \${PROJECT_NAME} "rosidl_typesupport_c")
target_link_libraries(wheels "\${c_typesupport}")
install(TARGETS wheels DESTINATION lib/own_c)
ament_export_dependencies(rosidl_default_runtime)
ament_package()
`,
  'src/own_c/own_c.c': `#include <stdio.h>
#include "own_c/msg/wheel_list.h"
#include "own_c/srv/set_wheel.h"
int main(void)
{
  own_c__msg__WheelList list;
  own_c__msg__WheelList__init(&list);
  own_c__msg__Wheel__Sequence__init(&list.wheels, own_c__msg__WheelList__MOST);
  own_c__srv__SetWheel_Request * request = own_c__srv__SetWheel_Request__create();
  printf("own: %d wheels of %.2f, %.2f\\n", (int)list.wheels.size, list.wheels.data[3].radius, request->wheel.radius);
  own_c__srv__SetWheel_Request__destroy(request);
  own_c__msg__WheelList__fini(&list);
  return 0;
}
`,

  // --- project() first, with a library of its own
  'src/early/package.xml': HEAD('early', AMENT),
  'src/early/CMakeLists.txt': `project(early)
cmake_minimum_required(VERSION 3.5)
find_package(ament_cmake REQUIRED)
add_library(early_words STATIC words.cpp)
add_executable(early early.cpp)
target_link_libraries(early early_words)
install(TARGETS early DESTINATION lib/early)
ament_package()
`,
  'src/early/words.cpp': 'const char* words() { return "project() came first"; }\n',
  'src/early/early.cpp': '#include <cstdio>\nconst char* words();\nint main() { std::puts(words()); }\n',

  // --- its own Find module finds nothing
  'src/optional/package.xml': HEAD('optional', AMENT),
  'src/optional/cmake/FindZMQ.cmake':
    'find_path(ZMQ_INCLUDE_DIR zmq.h)\nfind_library(ZMQ_LIBRARY zmq)\nset(ZMQ_INCLUDE_DIRS ${ZMQ_INCLUDE_DIR})\nset(ZMQ_LIBRARIES ${ZMQ_LIBRARY})\n',
  'src/optional/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(optional)
list(APPEND CMAKE_MODULE_PATH \${CMAKE_CURRENT_SOURCE_DIR}/cmake)
find_package(ament_cmake REQUIRED)
find_package(ZMQ)
include_directories(\${ZMQ_INCLUDE_DIRS})
add_executable(optional optional.cpp)
add_executable(bridge bridge.cpp)
target_link_libraries(bridge \${ZMQ_LIBRARIES})
install(TARGETS optional bridge DESTINATION lib/optional)
ament_package()
`,
  'src/optional/optional.cpp': SAYS('no ZMQ is needed here'),
  'src/optional/bridge.cpp': '#include <zmq.h>\nint main() { return zmq_ctx_new() == nullptr; }\n',

  // --- libraries by pkg-config, and of folders of the machine that builds
  'src/ids/package.xml': HEAD('ids', `${AMENT}\n  <build_depend>uuid</build_depend>`),
  'src/ids/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(ids)
find_package(ament_cmake REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(MACHINE zlib)
if(MACHINE_FOUND)
  message(FATAL_ERROR "pkg-config names libraries of this machine")
endif()
pkg_check_modules(UUID REQUIRED uuid)
find_library(UUID_PATH \${UUID_LIBRARIES} PATHS \${UUID_LIBRARY_DIRS})
include_directories(\${UUID_INCLUDE_DIRS})
add_executable(ids ids.cpp)
target_link_libraries(ids \${UUID_PATH})
find_library(MACHINE_MATH m PATHS /usr/lib/\${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu)
add_executable(found ids.cpp)
target_link_libraries(found \${UUID_PATH} \${MACHINE_MATH})
add_executable(named ids.cpp)
target_link_libraries(named \${UUID_PATH} /usr/lib/\${CMAKE_HOST_SYSTEM_PROCESSOR}-linux-gnu/libm.so)
install(TARGETS ids found named DESTINATION lib/ids)
ament_package()
`,
  'src/ids/ids.cpp': `#include <cstdio>
#include <cstring>
#include <uuid/uuid.h>
int main() {
  uuid_t one;
  uuid_t again;
  uuid_generate_random(one);
  char text[UUID_STR_LEN];
  uuid_unparse(one, text);
  const bool same = uuid_parse(text, again) == 0 && uuid_compare(one, again) == 0;
  uuid_generate_random(again);
  std::printf("%d characters, type %d, %d %d\\n", int(std::strlen(text)), uuid_type(one), same, uuid_compare(one, again) == 0);
}
`,

  // --- messages by definition only, without ament_cmake; scripts of a setup.cfg that CMake installs
  'src/only_messages/package.xml': HEAD('only_messages', `${AMENT}
  <buildtool_depend>rosidl_default_generators</buildtool_depend>
  <exec_depend>rosidl_default_runtime</exec_depend>
  <member_of_group>rosidl_interface_packages</member_of_group>`),
  'src/only_messages/msg/Level.msg': 'int32 level\n',
  'src/only_messages/tools/versions.py': 'import numbers_of_it\nprint(numbers_of_it.MAJOR)\n',
  'src/only_messages/tools/numbers_of_it.py': 'MAJOR = 1\n',
  'src/only_messages/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(only_messages)
find_package(rosidl_default_generators REQUIRED)
execute_process(COMMAND python3 "\${CMAKE_CURRENT_SOURCE_DIR}/tools/versions.py" COMMAND_ERROR_IS_FATAL ANY)
rosidl_generate_interfaces(\${PROJECT_NAME} "msg/Level.msg")
ament_package()
`,
  'src/scripts/package.xml': HEAD('scripts',
    `${AMENT}\n  <buildtool_depend>ament_cmake_python</buildtool_depend>\n  <exec_depend>rclpy</exec_depend>\n  <exec_depend>only_messages</exec_depend>`),
  'src/scripts/CMakeLists.txt': `cmake_minimum_required(VERSION 3.8)
project(scripts)
find_package(ament_cmake REQUIRED)
find_package(ament_cmake_python REQUIRED)
ament_python_install_package(\${PROJECT_NAME} SCRIPTS_DESTINATION lib/\${PROJECT_NAME})
ament_package()
`,
  'src/scripts/setup.cfg': '[options.entry_points]\nconsole_scripts =\n  levels = scripts.levels:main\n  whole = scripts.levels\n',
  'src/scripts/scripts/__init__.py': '',
  'src/scripts/scripts/levels.py': `from only_messages.msg import Level


def main():
    print('the level is', Level(level=4).level)
`,
};

let workspace: PackWorkspace;
let packed: { code: number | null; stderr: string; };
let said: string;
before(async () => {
  workspace = new PackWorkspace('shared');
  for (const [path, text] of Object.entries(FILES)) workspace.write(path, text);
  workspace.write('workspace.yaml', `schema: 1
name: habits
packages: [src/*]
launch:
${['newer', 'a_user', 'in_c', 'early', 'optional'].map((one) => `  - {package: ${one}, executable: ${one}}\n`).join('')}  - {package: own_c, executable: wheels}
  - {package: scripts, executable: levels}
  - {package: ids, executable: ids}
`);
  packed = await workspace.run(['pack', '--quick'], { PYTHONDONTWRITEBYTECODE: '' });
  assert.equal(packed.code, 0, packed.stderr);
  said = (await workspace.run(['run', 'site', '--for', '120s'])).stdout;
}, { timeout: 900_000 });
after(() => workspace.close());

test('a package that asks for a newer CMake is configured by the older one, with a warning', () => {
  assert.match(packed.stderr,
    /warning\[R2W0529\]: package `newer` asks for CMake 99\.1\.2, which is newer than the one on this machine\n +--> src\/newer\/CMakeLists\.txt:1:1\n/);
  assert.match(said, /^\[newer-1\] made by 2\.1 of (?:\.\/)?inner\/newer\.cpp$/m);
});

test('the warning comes again from the cache', async () => {
  const again = await workspace.run(['build', '--quick']);
  assert.equal(again.code, 0, again.stderr);
  assert.match(again.stderr, /warning\[R2W0529\]: package `newer`/);
});

test('a package without package.xml is built for those that need it', () => {
  assert.match(said, /^\[a_user-2\] twice 21 is 42$/m);
  assert.doesNotMatch(packed.stderr, /R2W0515/);
  assert.doesNotMatch(packed.stderr, /vendored/);
});

test('one that is for another machine is skipped, with its own words and their line', () => {
  assert.match(packed.stderr,
    /warning\[R2W0519\]: package `board_firmware` is skipped: CMakeLists\.txt of package `board_firmware` failed: set IDF_PATH first\n +--> src\/board\/CMakeLists\.txt:3/);
});

test('C headers of messages have structures and functions', () => {
  assert.match(said, /^\[in_c-3\] C: gripper w=1\.0 elbow 0\.25 equal 1, then 0, 3 requests$/m);
  assert.match(said, /^\[in_c-3\] C\+\+: 1\.5$/m);
});

test('C headers of the messages of the package itself are made before they are installed', () => {
  assert.match(said, /^\[wheels-6\] own: 4 wheels of 0\.25, 0\.25$/m);
});

test('project() may come before cmake_minimum_required()', () => {
  assert.match(said, /^\[early-4\] project\(\) came first$/m);
});

test('a library that a Find module does not find takes only what links it along', () => {
  assert.match(said, /^\[optional-5\] no ZMQ is needed here$/m);
});

test('pkg-config and find_library() know libraries of the site, not those of this machine', () => {
  assert.match(said, /^\[ids-8\] 36 characters, type 4, 1 0$/m);
  const programs = globSync(join(workspace.root, 'site/programs/**/*.wasm')).join(' ');
  assert.match(programs, /\bids\b/);
  assert.doesNotMatch(programs, /\b(?:found|named)\b/);
});

test('scripts of a setup.cfg that CMake installs run, with messages of a package that does not look for ament_cmake', () => {
  assert.match(said, /^\[levels-7\] the level is 4$/m);
  assert.ok(existsSync(join(workspace.root, 'site/site.json')));
});

test('generators in Python leave no compiled files in the environment, which has a seal, and in the sources', () => {
  const generators = join(workspace.cache, 'ros2wasm/environments/*/share/rosidl_typesupport_wasm_cpp/generator');
  assert.ok(globSync(generators).length > 0);
  assert.deepEqual([...globSync(join(generators, '**/*.pyc')), ...globSync(join(workspace.root, 'src/**/*.pyc'))], []);
});
