// Builds the files that go into every site, and runtime_assets.json that lists them with size and sha256.
// usage: node runtime/build.mjs --out FOLDER [--texts FOLDER] [--sentences FILE]. Same sources give the same bytes.
// --texts: the page's texts in another language (other_texts.ts), and its sentences.json (other_sentences.ts).
// --sentences: writes which sentences these are, with what --texts has for them.

import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { basename, join, relative, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { parseArgs } from 'node:util';
import { build } from 'esbuild';
import { staticScript } from './opencv_script.mjs';
import { components, takeInputs } from './components.mjs';
import { languageOf, otherTexts } from './other_texts.ts';

const root = fileURLToPath(new URL('..', import.meta.url));
const { values } = parseArgs({ options: { out: { type: 'string' }, texts: { type: 'string' }, sentences: { type: 'string' } } });
const usage = 'usage: build.mjs --out FOLDER [--texts FOLDER] [--sentences FILE]';
const translated = values.texts === undefined ? [] : [otherTexts(values.texts)];
const others = values.texts === undefined && values.sentences === undefined ? undefined : await import('./other_sentences.ts');
const sentences = sentencesOfFolder();
const seen = new Set();
if (others !== undefined) translated.push(others.otherSentences(sentences, seen));

function sentencesOfFolder() {
  const file = values.texts === undefined ? undefined : join(values.texts, 'sentences.json');
  return file !== undefined && existsSync(file) ? JSON.parse(readFileSync(file, 'utf8')) : {};
}

function inLanguage(html) {
  if (others === undefined) return html;
  for (const sentence of others.htmlSentences(html)) seen.add(sentence);
  const told = others.htmlInOtherWords(html, sentences);
  return values.texts === undefined ? told : told.replace('<html lang="en">', `<html lang="${languageOf(values.texts)}">`);
}

/**
 * One row per file of the site.
 * kind: "modules" is an ES module whose dynamic imports become files of their own, each complete, so that the page
 * needs one request before it starts, but for mount.tsx: it shares its code with the panels that come when they are
 * opened, in files that index.html asks for at once; "classic" one plain script;
 * "style" one sheet; "copy" the file as it is; "node" a module for Node.js; "wasm" a program, which its own script builds
 * into a folder beside OUT; "carried" a page with its program in it, the one of sites in one HTML file.
 */
const rows = [
  { file: 'index.html', from: 'runtime/site/ui/index.html', kind: 'copy', role: 'page' },
  { file: 'app.webmanifest', from: 'runtime/site/ui/app.webmanifest', kind: 'copy', role: 'web_manifest' },
  { file: 'icon.svg', from: 'runtime/site/ui/icon.svg', kind: 'copy', role: 'icon' },
  { file: 'start.js', from: 'runtime/site/ui/start.ts', kind: 'modules', role: 'script' },
  { file: 'boot.js', from: 'runtime/site/ui/boot.ts', kind: 'classic', role: 'script' },
  { file: 'course.js', from: 'runtime/site/ui/course.ts', kind: 'classic', role: 'course_script' },
  { file: 'node_worker.js', from: 'runtime/site/workers/node_worker_main.ts', kind: 'classic', role: 'worker' },
  { file: 'python_worker.js', from: 'runtime/site/session/python_worker_main.ts', kind: 'classic', role: 'python_worker' },
  { file: 'service_worker.js', from: 'runtime/site/session/service_worker.ts', kind: 'classic', role: 'service_worker' },
  { file: 'carried_page.html', from: 'runtime/site/ui/carried_page.ts', kind: 'carried', role: 'carried_page' },
  { file: 'headless.js', from: 'runtime/site/ros2cli/headless_run_main.ts', kind: 'node', role: 'headless' },
  { file: 'ros2.js', from: 'runtime/site/ros2cli/headless_main.ts', kind: 'node', role: 'headless_ros2' },
  { file: 'launch_evaluator.wasm', from: 'runtime/launch_evaluator/build.py', kind: 'wasm', role: 'launch_evaluator' },
  { file: 'styles.css', from: 'runtime/site/ui/styles/index.css', kind: 'style', role: 'style' },
  { file: 'panels.css', from: 'runtime/site/ui/styles/panels.css', kind: 'style', role: 'style' },
];

const shared = {
  absWorkingDir: root,
  bundle: true,
  minify: true,
  charset: 'utf8',
  legalComments: 'none',
  logLevel: 'warning',
  jsx: 'automatic',
  jsxImportSource: 'preact',
  target: 'es2022',
};

const options = {
  modules: { format: 'esm', platform: 'browser' },
  classic: { format: 'iife', platform: 'browser' },
  style: {},
  node: {
    format: 'esm',
    platform: 'node',
    target: 'node26',
    // The browser modules of yaml: its build for Node.js calls require(), which ES modules do not have.
    alias: { yaml: join(root, 'node_modules/yaml/browser/index.js') },
  },
};

/**
 * @foxglove/rosmsg is one file: with the reader of ROS 2's definitions come a grammar and a parser generator for ROS 1's
 * and MD5, 30 kB that nothing here calls. They are skipped of what sites load: webpack's modules by their content.
 */
const unusedOfRosmsg = new Map([
  ['function Column(grammar', '(module) => { module.exports = { Grammar: { fromCompiled: () => undefined } }; }'],
  ['var grammar = {', '(module, exports) => { exports.default = {}; }'],
  ['__WEBPACK_AMD_DEFINE_FACTORY__', '() => {}'],
  ['Md5.AddUnsigned =', '(module, exports) => { exports.Md5 = {}; }'],
]);

const leanRosmsg = {
  name: 'lean-rosmsg',
  setup(esbuild) {
    esbuild.onLoad({ filter: /@foxglove[\\/]rosmsg[\\/]dist[\\/]index\.js$/ }, ({ path }) => {
      let left = unusedOfRosmsg.size;
      const contents = readFileSync(path, 'utf8')
        .replace(/(\n\/\*{3}\/ \d+:\n)\/\*{3}\/ ([^]*?\n\/\*{3}\/ \}\)),?\n/g, (whole, head, body) => {
          for (const [mark, stub] of unusedOfRosmsg) {
            if (!body.includes(mark)) continue;
            left -= 1;
            return `${head}(${stub}),\n`;
          }
          return whole;
        });
      if (left !== 0) throw new Error(`${path} is not as it was: ${left} of its parts are not found`);
      return { contents };
    });
  },
};

/** jpeg-js gives its file as a Buffer of Node.js, which a browser does not have. */
const jpegBytes = {
  name: 'jpeg-bytes',
  setup(esbuild) {
    esbuild.onLoad({ filter: /jpeg-js[\\/]lib[\\/]encoder\.js$/ }, ({ path }) => {
      const source = readFileSync(path, 'utf8');
      const contents = source.replace('Buffer.from(byteout)', 'Uint8Array.from(byteout)');
      if (contents === source) throw new Error(`${path} is not as it was`);
      return { contents };
    });
  },
};

/** OpenCV.js without its WebAssembly, which sites have in the package that has cv2, and without dynamic code. */
const staticOpenCv = {
  name: 'static-opencv',
  setup(esbuild) {
    esbuild.onLoad({ filter: /@opencvjs[\\/]web[\\/]lib[\\/]opencv_js\.js$/ }, ({ path }) => ({ contents: staticScript(readFileSync(path, 'utf8')) }));
  },
};

/** Leaves dynamic imports of our files out of the bundle and notes them: file name -> source. */
function separateImports(later) {
  return {
    name: 'separate-imports',
    setup(esbuild) {
      esbuild.onResolve({ filter: /^\./ }, ({ kind, path, resolveDir }) => {
        if (kind !== 'dynamic-import') return undefined;
        const file = basename(path).replace(/\.[^.]+$/, '.js');
        later.set(file, relative(root, join(resolveDir, path)));
        return { path: `./${file}`, external: true };
      });
    },
  };
}

/** The page's program and, file by file, the panels and parts that it loads later. They share one Preact. */
async function buildShared({ file, from }, out) {
  const { metafile } = await build({
    ...shared,
    ...options.modules,
    entryPoints: { [file.replace(/\.[^.]+$/, '')]: from },
    outdir: out,
    plugins: [leanRosmsg, ...translated],
    splitting: true,
    chunkNames: '[name]-[hash]',
    metafile: true,
  });
  const name = (path) => basename(path);
  takeInputs(metafile);
  const outputs = new Map(Object.entries(metafile.outputs).map(([path, output]) => [name(path), output]));
  const needed = new Set([file]);
  for (const each of needed) {
    for (const { path, kind } of outputs.get(each).imports) {
      if (kind === 'import-statement') needed.add(name(path));
    }
  }
  const page = join(out, 'index.html');
  const asked = `<link rel="modulepreload" href="${file}">`;
  const html = readFileSync(page, 'utf8');
  if (!html.includes(asked)) throw new Error(`index.html does not preload ${file}`);
  const links = [...needed].sort().map((each) => `<link rel="modulepreload" href="${each}">`);
  writeFileSync(page, html.replace(asked, links.join('\n')));
}

/** Its policy is that of index.html, with what only this page can make in place of what the host has. */
async function buildCarried({ file, from }, out) {
  const { outputFiles, metafile } = await build({
    ...shared,
    ...options.classic,
    entryPoints: [from],
    outdir: out,
    write: false,
    metafile: true,
    plugins: translated,
  });
  takeInputs(metafile);
  const program = outputFiles[0].text.replaceAll('</', '<\\/');
  const hash = `'sha256-${createHash('sha256').update(program).digest('base64')}'`;
  const ui = (name) => readFileSync(join(root, 'runtime/site/ui', name), 'utf8');
  const [, policy] = ui('index.html').match(/Content-Security-Policy" content="([^"]*)"/);
  const carried = policy.split('; ').map((directive) => {
    const [name, ...sources] = directive.split(' ');
    const own = sources.map((source) => (source === "'self'" ? 'blob:' : source));
    return [name, ...(name === 'script-src' ? [hash] : []), ...new Set(own)].join(' ');
  });
  const html = ui(file).replace('POLICY', () => carried.join('; ')).replace('PROGRAM', () => program);
  writeFileSync(join(out, file), inLanguage(html));
}

async function buildRow(row, out) {
  if (row.kind === 'carried') {
    await buildCarried(row, out);
    return;
  }
  if (row.kind === 'copy') {
    const bytes = readFileSync(join(root, row.from));
    writeFileSync(join(out, row.file), row.role === 'page' ? inLanguage(bytes.toString()) : bytes);
    return;
  }
  if (row.kind === 'wasm') {
    // One folder whatever --out is: what has been compiled is compiled once.
    const folder = join(root, 'build', 'launch');
    execFileSync('python3', [join(root, row.from), '--out', folder], { stdio: 'inherit' });
    writeFileSync(join(out, row.file), readFileSync(join(folder, row.file)));
    return;
  }
  const name = row.file.replace(/\.[^.]+$/, '');
  const later = new Map();
  const { metafile } = await build({
    ...shared,
    ...options[row.kind],
    entryPoints: { [name]: row.from },
    outdir: out,
    // Headless programs say what they say in English.
    plugins: [leanRosmsg, staticOpenCv, jpegBytes, ...(row.kind === 'node' ? [] : translated), ...(row.kind === 'modules' ? [separateImports(later)] : [])],
    metafile: true,
  });
  if (row.kind !== 'node') takeInputs(metafile); // headless programs are in no site
  for (const [file, from] of later) {
    if (file === 'mount.js') await buildShared({ file, from }, out);
    else await buildRow({ file, from, kind: row.kind }, out);
  }
}

if (values.out === undefined) {
  console.error(usage);
  process.exit(2);
}
const out = resolve(values.out);
rmSync(out, { recursive: true, force: true });
mkdirSync(out, { recursive: true });
for (const row of rows) await buildRow(row, out);
for (const sentence of Object.keys(sentences)) if (!seen.has(sentence)) console.error(`sentences.json: no page says: ${sentence}`);
if (values.sentences !== undefined) {
  const table = Object.fromEntries([...seen].sort().map((sentence) => [sentence, sentences[sentence] ?? '']));
  writeFileSync(values.sentences, `${JSON.stringify(table, null, 1)}\n`);
}
writeFileSync(join(out, 'components.json'), `${JSON.stringify(components(root), null, 1)}\n`);

const roles = new Map([
  ...rows.map((row) => [row.file, row.role]),
  ['launch_evaluation.js', 'launch_script'],
  ['components.json', 'components'],
]);
const assets = readdirSync(out)
  .sort()
  .map((file) => {
    const bytes = readFileSync(join(out, file));
    return {
      file: basename(file),
      role: roles.get(file) ?? 'script', // what is imported later
      size: bytes.length,
      sha256: createHash('sha256').update(bytes).digest('hex'),
    };
  });
// Which libraries Pyodide's distribution has: read by pack, and no file of sites.
writeFileSync(join(out, 'python_libraries.json'), readFileSync(join(root, 'node_modules/pyodide/pyodide-lock.json')));
const constants = JSON.parse(readFileSync(join(root, 'runtime/protocol/constants.json'), 'utf8'));
const protocol = constants.values.find((value) => value.name === 'protocol_version').value;
writeFileSync(join(out, 'runtime_assets.json'), `${JSON.stringify({ schema: 1, protocol, assets }, null, 1)}\n`);
