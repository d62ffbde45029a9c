// ros2 pkg list, executables, prefix, xml.

import { type Command, CommandError, type Context, has } from './command.ts';
import { programsOf } from './programs.ts';

function known(context: Context, name: string): string {
  if (!context.session.site.packages.includes(name)) throw new CommandError('Package not found');
  return name;
}

export const pkgCommands: readonly Command[] = [
  {
    words: ['pkg', 'executables'],
    help: 'Output a list of package specific executables',
    positionals: [{ name: 'package_name', meaning: 'program_package', optional: true }],
    options: [{ names: ['--full-path'], help: 'Show the full path for each executable' }],
    run: (context, given) => {
      const { site, prefix } = context.session;
      const [wanted] = given.positionals;
      if (wanted !== undefined) known(context, wanted);
      for (const { package: from, executable } of programsOf(site)) {
        if (wanted !== undefined && from !== wanted) continue;
        context.print(has(given, 'full-path') ? `${prefix}/lib/${from}/${executable}` : `${from} ${executable}`);
      }
      return Promise.resolve(0);
    },
  },
  {
    words: ['pkg', 'list'],
    help: 'Output a list of available packages',
    positionals: [],
    options: [],
    run: (context) => {
      for (const name of [...context.session.site.packages].sort()) context.print(name);
      return Promise.resolve(0);
    },
  },
  {
    words: ['pkg', 'prefix'],
    help: 'Output the prefix path of a package',
    positionals: [{ name: 'package_name', meaning: 'package' }],
    options: [{ names: ['--share'], help: 'Show share directory for the package' }],
    run: (context, given) => {
      const name = known(context, given.positionals[0]!);
      context.print(`${context.session.prefix}${has(given, 'share') ? `/share/${name}` : ''}`);
      return Promise.resolve(0);
    },
  },
  {
    words: ['pkg', 'xml'],
    help: 'Output the XML of the package manifest or a specific tag',
    positionals: [{ name: 'package_name', meaning: 'package' }],
    options: [{ names: ['--tag', '-t'], value: 'TAG', help: 'The XML tag to output, e.g. version' }],
    run: (context, given) => {
      const name = known(context, given.positionals[0]!);
      throw new CommandError(
        `The package.xml of '${name}' is not in this site: of a package a site has what its nodes read. The workspace and the channel have it.`,
      );
    },
  },
];
