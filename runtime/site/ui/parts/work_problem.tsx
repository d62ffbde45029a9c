// Why what was asked for in a form was not done.

export function WorkProblem({ text }: { readonly text: string; }) {
  return text === '' ? null : (
    <p class="work-problem" role="alert">
      {text}
    </p>
  );
}
