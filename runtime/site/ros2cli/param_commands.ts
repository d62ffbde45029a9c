// ros2 param list, get, set, delete, describe, dump, load.

import { type Command, CommandError, type Context, has } from './command.ts';
import { shown } from './graph_lists.ts';
import { findNode } from './node_commands.ts';
import { descriptorsOf, namesOf, setText, setValue, setValues, valuesOf } from './parameter_calls.ts';
import { dumpText, kindOf, parameterKinds, pythonValue } from './parameters.ts';
import { reprFloat } from './python_text.ts';

const node = { name: 'node_name', meaning: 'node' } as const;
const parameter = { name: 'parameter_name', meaning: 'parameter' } as const;

function fullNode(context: Context, given: string): string {
  const found = findNode(context.session.graph(), given);
  if (found === undefined) throw new CommandError('Node not found');
  return found.name;
}

export const paramCommands: readonly Command[] = [
  {
    words: ['param', 'list'],
    help: 'Output a list of available parameters',
    positionals: [{ ...node, optional: true }],
    options: [
      { names: ['--include-hidden-nodes'], help: 'Consider hidden nodes as well' },
      { names: ['--param-type'], help: 'Print parameter types with parameter names' },
    ],
    run: async (context, given) => {
      const [wanted] = given.positionals;
      const graph = context.session.graph();
      const nodes = wanted === undefined ? shown(graph.nodes, has(given, 'include-hidden-nodes')).map(({ name }) => name) : [fullNode(context, wanted)];
      for (const name of new Set(nodes)) {
        // Those without parameters are passed over.
        const serves = graph.nodes.some(({ services }) => services.some((service) => service.name === `${name}/list_parameters`));
        if (!serves) {
          if (wanted !== undefined) throw new CommandError(`Node ${name} has no parameter services`);
          continue;
        }
        const names = await namesOf(context, name);
        const values = has(given, 'param-type') ? await valuesOf(context, name, names) : [];
        if (wanted === undefined) context.print(`${name}:`);
        names.forEach((each, i) => context.print(`  ${each}${values[i] === undefined ? '' : ` (type: ${kindOf(values[i]).name})`}`));
      }
      return 0;
    },
  },
  {
    words: ['param', 'get'],
    help: 'Get parameter',
    positionals: [node, parameter],
    options: [{ names: ['--hide-type'], help: 'Hide the type information' }],
    run: async (context, given) => {
      const [value] = await valuesOf(context, fullNode(context, given.positionals[0]!), [given.positionals[1]!]);
      if (value === undefined || kindOf(value).field === '') {
        throw new CommandError('Parameter not set');
      }
      context.print(has(given, 'hide-type') ? pythonValue(value) : `${kindOf(value).label} ${pythonValue(value)}`);
      return 0;
    },
  },
  {
    words: ['param', 'set'],
    help: 'Set parameter',
    positionals: [node, parameter, { name: 'value', meaning: 'text' }],
    options: [],
    run: async (context, given) => {
      const [of = '', name = '', text = ''] = given.positionals;
      const { successful, reason } = await setText(context, fullNode(context, of), name, text);
      if (successful) context.print(`Set parameter successful${reason === '' ? '' : `: ${reason}`}`);
      else throw new CommandError(`Setting parameter failed${reason === '' ? '' : `: ${reason}`}`);
      return 0;
    },
  },
  {
    words: ['param', 'delete'],
    help: 'Delete parameter',
    positionals: [node, parameter],
    options: [],
    run: async (context, given) => {
      const [of = '', name = ''] = given.positionals;
      const { successful, reason } = await setValue(context, fullNode(context, of), name, { type: 0 });
      if (successful) context.print('Deleted parameter successfully');
      else throw new CommandError(`Deleting parameter failed${reason === '' ? '' : `: ${reason}`}`);
      return 0;
    },
  },
  {
    words: ['param', 'describe'],
    help: 'Show descriptive information about declared parameters',
    positionals: [node, parameter],
    options: [],
    run: async (context, given) => {
      const [of = '', name = ''] = given.positionals;
      for (const each of await descriptorsOf(context, fullNode(context, of), [name])) {
        const lines = [`Parameter name: ${each.name}`, `  Type: ${parameterKinds[each.type]?.name ?? 'unknown'}`];
        if (each.description !== '') lines.push(`  Description: ${each.description}`);
        lines.push('  Constraints:');
        if (each.read_only) lines.push('    Read only: true');
        for (const range of each.floating_point_range) {
          lines.push(`    Min value: ${reprFloat(range.from_value)}`, `    Max value: ${reprFloat(range.to_value)}`);
          if (range.step !== 0) lines.push(`    Step: ${reprFloat(range.step)}`);
        }
        for (const range of each.integer_range) {
          lines.push(`    Min value: ${range.from_value}`, `    Max value: ${range.to_value}`);
          if (range.step !== 0n) lines.push(`    Step: ${range.step}`);
        }
        if (each.additional_constraints !== '') lines.push(`    Additional constraints: ${each.additional_constraints}`);
        context.print(lines.join('\n'));
      }
      return 0;
    },
  },
  {
    words: ['param', 'dump'],
    help: 'Show all of the parameters of a node in a YAML file format',
    positionals: [node],
    options: [],
    run: async (context, given) => {
      const name = fullNode(context, given.positionals[0]!);
      const names = await namesOf(context, name);
      const values = await valuesOf(context, name, names);
      context.print(dumpText(name, new Map(names.flatMap((each, i) => values[i] === undefined ? [] : [[each, values[i]] as const]))));
      return 0;
    },
  },
  {
    words: ['param', 'load'],
    help: 'Load parameter file for a node',
    positionals: [node, { name: 'parameter_file', meaning: 'text' }],
    options: [{ names: ['--use-wildcard'], help: "Load parameters in the '/**' namespace into the node" }],
    run: async (context, given) => {
      const [of = '', file = ''] = given.positionals;
      const name = fullNode(context, of);
      const text = await context.readText(file);
      if (text === undefined) throw new CommandError(`No such file: '${file}'`);
      const { parametersOfFile } = await import('./parameter_file.ts');
      const parameters = parametersOfFile(text, name, has(given, 'use-wildcard'));
      const results = await setValues(context, name, parameters);
      parameters.forEach((parameter, i) => {
        const { successful, reason } = results[i] ?? { successful: false, reason: '' };
        const what = `Set parameter ${parameter.name} ${successful ? 'successful' : 'failed'}${reason === '' ? '' : `: ${reason}`}`;
        if (successful) context.print(what);
        else context.warn(what);
      });
      return 0;
    },
  },
];
