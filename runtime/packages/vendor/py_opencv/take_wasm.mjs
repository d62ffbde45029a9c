// Writes the WebAssembly that OpenCV.js carries as text. usage: node take_wasm.mjs SCRIPT FILE
import { readFileSync, writeFileSync } from 'node:fs';
import { embeddedWasm } from '../../../opencv_script.mjs';

const [script, file] = process.argv.slice(2);
writeFileSync(file, embeddedWasm(readFileSync(script, 'utf8')).wasm);
