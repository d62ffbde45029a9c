// Modules that are embedded in a page have no addresses relative to each other: their imports of `./NAME.js` are renamed.
// Reads the output of esbuild; tests/unit/site/module_links.test.ts compares it with a parser of JavaScript.

const always = /\b(from|import)\s*(["'])\.\/([\w.-]+\.js)\2/g;
const later = /\bimport\(\s*(["'])\.\/([\w.-]+\.js)\1\s*\)/g;

/** Names of the files that the module needs before it runs. */
export function neededModules(text: string): string[] {
  return [...new Set(Array.from(text.matchAll(always), ([, , , name]) => name ?? ''))];
}

/** `addresses`: of those; a module that is imported later is asked for by `importer("NAME.js")`. */
export function linkedModule(text: string, addresses: ReadonlyMap<string, string>, importer: string): string {
  return text
    .replace(always, (_, word: string, _quote, name: string) => `${word}${JSON.stringify(addresses.get(name))}`)
    .replace(later, (_, _quote, name: string) => `${importer}(${JSON.stringify(name)})`);
}
