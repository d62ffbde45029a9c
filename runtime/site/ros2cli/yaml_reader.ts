// What reads YAML, loaded when it is first asked for. Later it is there at once, which a stepped run counts on.

type YamlReader = typeof import('../decode/read_yaml.ts');

let loading: Promise<YamlReader> | undefined;

export function yamlReader(): Promise<YamlReader> {
  if (loading === undefined) {
    loading = import('../decode/read_yaml.ts');
    // Who asks next tries again.
    loading.catch(() => {
      loading = undefined;
    });
  }
  return loading;
}
