// Loads the YAML reader at its first use. Later it is there at once, which a stepped run relies on.

type YamlReader = typeof import('../decode/read_yaml.ts');

let loading: Promise<YamlReader> | undefined;

export function yamlReader(): Promise<YamlReader> {
  if (loading === undefined) {
    loading = import('../decode/read_yaml.ts');
    // The next call tries again.
    loading.catch(() => {
      loading = undefined;
    });
  }
  return loading;
}
