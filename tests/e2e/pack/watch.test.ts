// `ros2wasm serve --watch`: a change of the source is packed again and open pages reload; a mistake in
// it leaves the last good site and is shown.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { describe, test } from 'node:test';
import { chromium } from 'playwright-core';
import { chromiumOptions } from '../support/chromium.ts';
import { Scratch, ServedSite } from '../support/served_site.ts';

const WATCHDOG = { timeout: 600_000 };

const PACKAGE_XML = `<?xml version="1.0"?>
<package format="3">
  <name>mini</name>
  <version>1.0.0</version>
  <description>Prints one line.</description>
  <maintainer email="maintainers@ros2wasm.invalid">ros2wasm maintainers</maintainer>
  <license>Apache-2.0</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export><build_type>ament_cmake</build_type></export>
</package>
`;
const CMAKE_LISTS = `cmake_minimum_required(VERSION 3.8)
project(mini)
find_package(ament_cmake REQUIRED)
add_executable(hello src/hello.cpp)
install(TARGETS hello DESTINATION lib/\${PROJECT_NAME})
ament_package()
`;
const MANIFEST = `schema: 1
name: mini
packages: [src/mini]
launch:
  - package: mini
    executable: hello
`;

function program(word: string): string {
  return `#include <cstdio>\nint main() { std::puts("hello from ${word}"); }\n`;
}

/** A workspace with one program, which needs no package of ROS: quick to build. */
function makeWorkspace(scratch: Scratch): { manifest: string; source: string; site: string; } {
  scratch.file('ws/src/mini/package.xml', PACKAGE_XML);
  scratch.file('ws/src/mini/CMakeLists.txt', CMAKE_LISTS);
  scratch.file('ws/src/mini/src/hello.cpp', program('one'));
  return {
    manifest: scratch.file('ws/workspace.yaml', MANIFEST),
    source: 'ws/src/mini/src/hello.cpp',
    site: join(scratch.path, 'ws/site'), // inside of what is watched
  };
}

function startWatching(scratch: Scratch, site: string, manifest: string): Promise<ServedSite> {
  const environment = { ...process.env, XDG_CACHE_HOME: join(scratch.path, 'cache') };
  return ServedSite.start([site, '--port', '0', '--watch', manifest], environment);
}

describe('serve --watch', WATCHDOG, () => {
  test('pages reload when the source changes, and show what is wrong with it', async () => {
    using scratch = new Scratch();
    const { manifest, source, site } = makeWorkspace(scratch);
    await using server = await startWatching(scratch, site, manifest);
    const browser = await chromium.launch(chromiumOptions());
    try {
      const page = await browser.newPage();
      page.setDefaultTimeout(WATCHDOG.timeout / 4);
      const refused: string[] = [];
      page.on('console', (message) => {
        if (/Content Security Policy/.test(message.text())) refused.push(message.text());
      });
      await page.goto(server.url);
      await page.getByText('hello from one').first().waitFor();

      scratch.file(source, program('two'));
      await page.getByText('hello from two').first().waitFor();
      assert.match(server.errors, /src\/mini\/src\/hello\.cpp changed; packing again/);

      scratch.file(source, 'int main() { return oops; }\n');
      const problems = page.getByRole('alert').filter({ hasText: 'oops' });
      await problems.waitFor();
      assert.match(await problems.innerText(), /hello\.cpp/);
      await page.getByText('hello from two').first().waitFor();
      await server.until(() => server.errors.includes('last good site'), 'the remark on the failure');

      scratch.file(source, program('three'));
      await page.getByText('hello from three').first().waitFor();
      assert.equal(await problems.count(), 0);
      assert.deepEqual(refused, []);
    } finally {
      await browser.close();
    }
    assert.equal((await server.signal('SIGINT')).code, 130);
  });

  test('nothing of it is in the packed site, and no pack follows its own writing', async () => {
    using scratch = new Scratch();
    const { manifest, source, site } = makeWorkspace(scratch);
    await using server = await startWatching(scratch, site, manifest);
    const page = await (await fetch(server.url)).text();
    assert.match(page, /<script type="module" src="\.ros2wasm\/reload\.js\?[0-9a-f]+"><\/script>/);
    assert.doesNotMatch(readFileSync(join(site, 'index.html'), 'utf8'), /reload\.js/);
    assert.equal((await fetch(new URL('.ros2wasm/reload.js', server.url))).status, 200);
    // A change in the text that changes no byte of the site: packed, but no page reloads.
    scratch.file(source, `${program('one')}// a remark\n`);
    await server.until(() => server.errors.includes('the same as before'), 'the pack');
    const packs = server.errors.match(/packing again/g) ?? [];
    assert.equal(packs.length, 1, server.errors);
    assert.equal(await (await fetch(server.url)).text(), page);
  });

  test('packages outside of the workspace are watched from the first pack on', async () => {
    using scratch = new Scratch();
    const { source, site } = makeWorkspace(scratch);
    const outside = MANIFEST.replace('src/mini', '../ws/src/mini');
    const manifest = scratch.file('other/workspace.yaml', outside);
    await using server = await startWatching(scratch, site, manifest);
    scratch.file(source, program('two'));
    await server.until(() => server.errors.includes('pages reload'), 'the pack');
    assert.deepEqual(server.errors.match(/.*packing again/g), [
      '../ws/src/mini/src/hello.cpp changed; packing again',
    ]);
  });

  test('a workspace that does not pack is an error when there is no site yet', async () => {
    using scratch = new Scratch();
    const { manifest, source, site } = makeWorkspace(scratch);
    scratch.file(source, 'int main() { return oops; }\n');
    await assert.rejects(startWatching(scratch, site, manifest), /oops/);
  });
});
