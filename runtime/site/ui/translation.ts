// What a translation of texts has to have: the same names, and sentences made of the same things.
// `export const texts: Translation<typeof english> = {...}`, with `import type { texts as english }` of the English file.

export type Translation<T> = T extends string
  ? string
  : T extends (...given: infer Given) => infer Told
    ? (...given: Given) => Translation<Told>
    : { readonly [Name in keyof T]: Translation<T[Name]> };
