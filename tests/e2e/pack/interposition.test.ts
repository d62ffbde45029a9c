// Definitions that stand twice: natively the program and its shared libraries are linked apart, and the first one is
// everybody's. Within one of them, or with a static library, it is an error.
//
// Compatibility, works: a function or variable that a header defines (not `inline`) in a program and in shared libraries
// that it links, of its own package or of others: the program's definition is everybody's, else that of the first
// library
//
// Compatibility, differs: a function that is defined in a program and a shared library, called in the source that defines
// it -> may be that source's own: the compiler puts it into its caller

import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';

import { PackWorkspace } from '../support/pack_workspace.ts';

/** A header with definitions, as beginners write them. */
const HEADER = `#pragma once
int asked = 0;
const char* who() {
  ++asked;
  return WHO;
}
`;
const asker = (name: string): string =>
  `extern int asked;\nconst char* who();\nconst char* ask_${name}() { return who(); }\nint count_${name}() { return asked; }\n`;
const PROGRAM = `#include <cstdio>
#ifdef WHO
#include "who.hpp"
#endif
const char* ask_first();
const char* ask_second();
int count_first();
int count_second();
int main() {
  std::printf("%s, ", ask_second());
  std::printf("%s, ", ask_first());
  std::printf("%d, ", count_first());
  std::printf("%d\\n", count_second());
}
`;
const library = (name: string, kind: string): string =>
  `add_library(${name} ${kind} src/${name}/ask.cpp src/${name}/who.cpp)
target_compile_definitions(${name} PRIVATE "WHO=\\"${name}\\"")
target_include_directories(${name} PRIVATE include)
`;

let workspace: PackWorkspace;

function writeLibrary(folder: string, name: string): void {
  workspace.write(`${folder}/src/${name}/ask.cpp`, asker(name));
  workspace.write(`${folder}/src/${name}/who.cpp`, '#include "who.hpp"\n');
}

before(() => {
  workspace = new PackWorkspace();
  workspace.addPackage('askers', {}, {
    cmake: `${library('second', 'SHARED')}install(TARGETS second EXPORT export_askers ARCHIVE DESTINATION lib LIBRARY DESTINATION lib)
ament_export_targets(export_askers)
`,
  });
  workspace.write('src/askers/include/who.hpp', HEADER);
  writeLibrary('src/askers', 'second');
  workspace.addPackage('programs', {
    own: PROGRAM,
    theirs: PROGRAM,
    threaded: `#include <thread>\n${PROGRAM.replace('int main() {', 'void work() {')}int main() { std::thread(work).join(); }\n`,
  }, {
    depends: ['askers'],
    cmake: `find_package(askers REQUIRED)
${library('first', 'SHARED')}include_directories(include)
target_compile_definitions(own PRIVATE "WHO=\\"program\\"")
foreach(_program own theirs threaded)
  target_link_libraries(\${_program} first askers::second)
endforeach()
`,
  });
  workspace.write('src/programs/include/who.hpp', HEADER);
  writeLibrary('src/programs', 'first');
  workspace.write('workspace.yaml', `schema: 1
name: interposed
packages: [src/*]
launch:
  - {package: programs, executable: own}
  - {package: programs, executable: theirs}
  - {package: programs, executable: threaded}
`);
});
after(() => workspace.close());

for (const how of [[], ['--quick']]) {
  test(`the program's definition is everybody's, else that of the first library ${how.join('')}`, { timeout: 240_000 }, async () => {
    const packed = await workspace.run(['pack', ...how, '--output', 'site']);
    assert.equal(packed.code, 0, packed.stderr);
    assert.doesNotMatch(packed.stderr, /duplicate/);
    const ran = await workspace.run(['run', 'site', '--for', '60s']);
    assert.equal(ran.code, 0, `${ran.stdout}${ran.stderr}`);
    assert.match(ran.stdout, /^\[own-1\] program, program, 2, 2$/m);
    assert.match(ran.stdout, /^\[theirs-2\] first, first, 2, 2$/m);
    assert.match(ran.stdout, /^\[threaded-3\] first, first, 2, 2$/m);
  });
}

test('two definitions of one unit are an error: sources of a program, static libraries, one shared library', { timeout: 240_000 }, async () => {
  const units: Readonly<Record<string, string>> = {
    sources: 'add_executable(main src/main.cpp src/one/who.cpp src/two/who.cpp)\n',
    static: 'add_library(one STATIC src/one/whole.cpp)\nadd_executable(main src/main.cpp src/two/who.cpp)\ntarget_link_libraries(main one)\n',
    shared: 'add_library(one SHARED src/one/ask.cpp src/one/who.cpp src/two/who.cpp)\nadd_executable(main src/main.cpp src/two/who.cpp)\n'
      + 'target_link_libraries(main -Wl,--whole-archive one -Wl,--no-whole-archive)\n',
  };
  for (const [unit, cmake] of Object.entries(units)) {
    const packages = new PackWorkspace();
    try {
      packages.addPackage('twice', {}, {
        cmake: `include_directories(include)\nadd_compile_definitions("WHO=\\"unit\\"")\n${cmake}install(TARGETS main DESTINATION lib/\${PROJECT_NAME})\n`,
      });
      packages.write('src/twice/include/who.hpp', HEADER);
      for (const name of ['one', 'two']) {
        packages.write(`src/twice/src/${name}/ask.cpp`, asker('one'));
        packages.write(`src/twice/src/${name}/who.cpp`, '#include "who.hpp"\n');
      }
      packages.write('src/twice/src/one/whole.cpp', `#include "who.hpp"\n${asker('one')}`);
      packages.write('src/twice/src/main.cpp',
        'const char* ask_one();\nconst char* who();\nint main() { return who() != ' + (unit === 'sources' ? 'who' : 'ask_one') + '(); }\n');
      const packed = await packages.run(['pack']);
      assert.equal(packed.code, 1, `${unit}: ${packed.stderr}`);
      assert.match(packed.stderr, /^error\[R2W0505\]: cannot link `main` of package `twice`$/m, unit);
      assert.match(packed.stderr, /duplicate symbol: who\(\)/, unit);
    } finally {
      packages.close();
    }
  }
});
