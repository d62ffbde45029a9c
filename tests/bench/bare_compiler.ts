// The bare compiler for all that `ros2wasm build` built below a cache: the same commands without our program around them,
// and for links, whose flags that program adds, those that anybody gives.
import { spawnSync } from 'node:child_process';
import { readdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

/** A command that runs them anew, two packages at a time; what it makes takes the place of what was built. */
export function bareCompiler(cache: string): string[] {
  let found = 0;
  const scripts = readdirSync(cache, { recursive: true, encoding: 'utf8' })
    .filter((path) => path.endsWith('/build.ninja'))
    .map((path) => {
      const folder = dirname(join(cache, path));
      const listed = spawnSync('ninja', ['-C', folder, '-t', 'commands'], { encoding: 'utf8', maxBuffer: 1 << 28 });
      if (listed.status !== 0) throw new Error(listed.stderr);
      const script = join(folder, 'bare.sh');
      const commands = listed.stdout.split('\n').filter((line) => OURS.test(line)).map(bare);
      found += commands.length;
      writeFileSync(script, [`cd '${folder}'`, ...commands, ''].join('\n'));
      return script;
    });
  if (found === 0) throw new Error(`nothing was compiled below ${cache}`);
  const list = join(cache, 'bare.list');
  writeFileSync(list, scripts.join('\n'));
  return ['xargs', '-a', list, '-P', '2', '-n', '1', 'sh', '-e'];
}

const OURS = /^(?:: && )?(?:"[^"]*"|\S+) (?:compile-source|link-program) .*?-- /;

function bare(line: string): string {
  const command = line.replace(OURS, '').replace(/ && :$/, '');
  return line.includes(' link-program ') ? `${command} -O2 -fwasm-exceptions -sERROR_ON_UNDEFINED_SYMBOLS=0` : command;
}
