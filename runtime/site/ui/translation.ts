// The type of a translation of texts: it has the same names, and sentences with the same parameters.
// `export const texts: Translation<typeof english> = {...}`, with `import type { texts as english }` of the English file.

export type Translation<T> = T extends string ? string
  : T extends (...given: infer Given) => infer Told ? (...given: Given) => Translation<Told>
  : { readonly [Name in keyof T]: Translation<T[Name]>; };
