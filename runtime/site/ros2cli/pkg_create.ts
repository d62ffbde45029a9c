// ros2 pkg create: writes the files of a new package where the caller stores them. Nothing builds or runs them; the last line
// of the output says so.

import { allOf, type Command, CommandError, type Context, type Given, type NewFiles } from './command.ts';

const kinds = ['ament_cmake', 'ament_python', 'cmake'] as const;
type BuildType = (typeof kinds)[number];

interface NewPackage {
  readonly name: string;
  readonly kind: BuildType;
  readonly node: string | undefined;
  readonly description: string;
  readonly license: string;
  readonly maintainer: string;
  readonly email: string;
  readonly dependencies: readonly string[];
}

function readPackage(given: Given): NewPackage {
  const [name = ''] = given.positionals;
  if (!/^[a-z](?:_?[a-z0-9])*$/.test(name)) {
    throw new CommandError(`The package name '${name}' is not valid: it begins with a small letter and has small letters, digits and single underscores`);
  }
  const text = (option: string, otherwise: string): string => given.options.get(option) ?? otherwise;
  return {
    name,
    kind: kinds.find((kind) => kind === text('build-type', 'ament_cmake')) ?? 'ament_cmake',
    node: given.options.get('node-name'),
    // The tool's own placeholders: linters and people know them.
    description: text('description', 'TODO: Package description'),
    license: text('license', 'TODO: License declaration'),
    maintainer: text('maintainer-name', 'user'),
    email: text('maintainer-email', 'user@todo.todo'),
    dependencies: allOf(given, 'dependencies').flatMap((one) => one.split(' ')),
  };
}

function escaped(text: string): string {
  return text.replace(/&/g, '&amp;').replace(/</g, '&lt;').replace(/>/g, '&gt;').replace(/"/g, '&quot;');
}

function manifest({ name, kind, description, license, maintainer, email, dependencies }: NewPackage): string {
  const lines = [
    '<?xml version="1.0"?>',
    '<package format="3">',
    `  <name>${name}</name>`,
    '  <version>0.0.0</version>',
    `  <description>${escaped(description)}</description>`,
    `  <maintainer email="${escaped(email)}">${escaped(maintainer)}</maintainer>`,
    `  <license>${escaped(license)}</license>`,
    '',
    ...(kind === 'ament_cmake' ? ['  <buildtool_depend>ament_cmake</buildtool_depend>', ''] : []),
    ...dependencies.map((dependency) => `  <depend>${escaped(dependency)}</depend>`),
    ...(dependencies.length > 0 ? [''] : []),
    '  <export>',
    `    <build_type>${kind}</build_type>`,
    '  </export>',
    '</package>',
  ];
  return `${lines.join('\n')}\n`;
}

function setupPy({ name, node, description, license, maintainer, email }: NewPackage): string {
  const quoted = (text: string): string => `'${text.replace(/[\\']/g, '\\$&')}'`;
  return `from setuptools import find_packages, setup

package_name = '${name}'

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer=${quoted(maintainer)},
    maintainer_email=${quoted(email)},
    description=${quoted(description)},
    license=${quoted(license)},
    entry_points={
        'console_scripts': [${node === undefined ? '' : `\n            '${node} = ${name}.${node}:main',\n        `}],
    },
)
`;
}

function cmakeLists({ name, kind, node, dependencies }: NewPackage): string {
  const found = [...(kind === 'ament_cmake' ? ['ament_cmake'] : []), ...dependencies];
  const program = node === undefined ? '' : `
add_executable(${node} src/${node}.cpp)
${
    kind === 'ament_cmake' && dependencies.length > 0
      ? `ament_target_dependencies(${node} ${dependencies.join(' ')})\n`
      : ''
  }install(TARGETS ${node} DESTINATION lib/\${PROJECT_NAME})
`;
  return `cmake_minimum_required(VERSION 3.8)
project(${name})

${found.map((one) => `find_package(${one} REQUIRED)`).join('\n')}
${program}${kind === 'ament_cmake' ? '\nament_package()\n' : ''}`;
}

/** Path below the package's folder, and text; in the order in which they are made. */
function filesOf(made: NewPackage): readonly (readonly [path: string, text: string])[] {
  const { name, kind, node } = made;
  if (kind === 'ament_python') {
    return [
      ['package.xml', manifest(made)],
      ['setup.py', setupPy(made)],
      ['setup.cfg', `[develop]\nscript_dir=$base/lib/${name}\n[install]\ninstall_scripts=$base/lib/${name}\n`],
      [`resource/${name}`, ''],
      [`${name}/__init__.py`, ''],
      ...(node === undefined
        ? []
        : [[`${name}/${node}.py`, `def main():\n    print('Hi from ${name}.')\n\n\nif __name__ == '__main__':\n    main()\n`] as const]),
    ];
  }
  return [
    ['package.xml', manifest(made)],
    ...(node === undefined
      ? []
      : [[`src/${node}.cpp`, `#include <cstdio>\n\nint main()\n{\n  std::printf("hello world ${name} package\\n");\n  return 0;\n}\n`] as const]),
    ['CMakeLists.txt', cmakeLists(made)],
  ];
}

function make(context: Context, given: Given, files: NewFiles): number {
  const made = readPackage(given);
  if (made.node !== undefined && !/^[A-Za-z_]\w*$/.test(made.node)) throw new CommandError(`The node name '${made.node}' is not valid`);
  const below = given.options.get('destination-directory') ?? '.';
  const folder = `${below}/${made.name}`;
  if (files.exists(folder))
    throw new CommandError(
      `Aborted!\nThe directory already exists: ${folder}\nEither remove the directory or choose a different destination directory or package name.`,
    );
  context.print('going to create a new package');
  const facts: readonly (readonly [string, string])[] = [
    ['package name', made.name],
    ['destination directory', files.whole(below)],
    ['package format', '3'],
    ['version', '0.0.0'],
    ['description', made.description],
    ['maintainer', `['${made.maintainer} <${made.email}>']`],
    ['licenses', `['${made.license}']`],
    ['build type', made.kind],
    ['dependencies', `[${made.dependencies.map((one) => `'${one}'`).join(', ')}]`],
    ...(made.node === undefined ? [] : [['node_name', made.node] as const]),
  ];
  for (const [name, value] of facts) context.print(`${name}: ${value}`);
  context.print(`creating folder ${folder}`);
  for (const [path, text] of filesOf(made)) {
    if (!files.write(`${folder}/${path}`, text)) throw new CommandError(`${folder}/${path}: there is not enough room`);
    context.print(`creating ${folder}/${path}`);
  }
  context.warn(
    `${made.name} is in this page only, until it is closed. The site runs the packages that it was packed with: to run this one, put it into the workspace and pack that.`,
  );
  return 0;
}

export const pkgCreate: Command = {
  words: ['pkg', 'create'],
  help: 'Create a new ROS 2 package',
  positionals: [{ name: 'package_name', meaning: 'text' }],
  options: [
    { names: ['--package-format', '--package_format'], value: 'FORMAT', choices: ['3'], help: 'The package.xml format' },
    { names: ['--description'], value: 'TEXT', help: 'The description given in the package.xml' },
    { names: ['--license'], value: 'LICENSE', help: 'The license attached to this package' },
    { names: ['--destination-directory'], value: 'FOLDER', help: 'Directory where to create the package directory' },
    { names: ['--build-type'], value: 'TYPE', choices: kinds, help: 'The build type to process the package with' },
    { names: ['--dependencies'], value: 'PACKAGE', many: true, help: 'List of dependencies' },
    { names: ['--maintainer-email'], value: 'ADDRESS', help: 'Email address of the maintainer of this package' },
    { names: ['--maintainer-name'], value: 'NAME', help: 'Name of the maintainer of this package' },
    { names: ['--node-name'], value: 'NAME', help: 'Name of the empty executable' },
  ],
  run: (context, given) => {
    const { newFiles } = context;
    if (newFiles === undefined) throw new CommandError('ros2 pkg create is for the terminal of the page: in a shell, make the package in the workspace');
    return Promise.resolve(make(context, given, newFiles));
  },
};
