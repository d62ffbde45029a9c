// A name with slashes and underscores (topic, type, package), which may break after them when room is short.

export function Name({ text }: { readonly text: string; }) {
  return (
    <>
      {text
        .split(/(?<=[/_])(?=[^/_])/)
        .map((part, index) => (index === 0 ? part : [<wbr />, part]))}
    </>
  );
}
