// A field for the name of a topic or type, which offers those that there are.

interface NameFieldProps {
  /** The id of the list of offers: another one in each panel. */
  readonly id: string;
  readonly words: string;
  readonly value: string;
  readonly offers: readonly string[];
  readonly placeholder: string;
  readonly onInput: (name: string) => void;
}

export function NameField({ id, words, value, offers, placeholder, onInput }: NameFieldProps) {
  return (
    <>
      <label class="editor-field">
        <span class="editor-name">{words}</span>
        <input
          type="text"
          class="field"
          list={id}
          value={value}
          autocomplete="off"
          autocapitalize="off"
          spellcheck={false}
          placeholder={placeholder}
          onInput={(event) => onInput(event.currentTarget.value)}
        />
      </label>
      <datalist id={id}>
        {offers.map((name) => (
          <option key={name} value={name} />
        ))}
      </datalist>
    </>
  );
}
