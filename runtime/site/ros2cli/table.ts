// All commands of `ros2`, in the order in which help shows them. A new one is a row in its group's file.

import { actionCommands } from './action_commands.ts';
import { bagCommands } from './bag_commands.ts';
import type { Command } from './command.ts';
import { componentCommands } from './component_commands.ts';
import { controlCommands } from './control_commands.ts';
import { controlLists } from './control_lists.ts';
import { daemonCommands } from './daemon_commands.ts';
import { doctorCommand, wtfCommand } from './doctor_commands.ts';
import { interfaceCommands } from './interface_commands.ts';
import { launchCommand } from './launch_command.ts';
import { lifecycleCommands } from './lifecycle_commands.ts';
import { nodeCommands } from './node_commands.ts';
import { paramCommands } from './param_commands.ts';
import { pkgCreate } from './pkg_create.ts';
import { pkgCommands } from './pkg_commands.ts';
import { runCommand } from './run_command.ts';
import { serviceCommands } from './service_commands.ts';
import { topicCommands } from './topic_commands.ts';
import { serviceEcho, topicEcho } from './topic_echo.ts';
import { topicMeasures } from './topic_measures.ts';
import { topicPub } from './topic_pub.ts';

export const commands: readonly Command[] = [
  ...actionCommands,
  ...bagCommands,
  ...componentCommands,
  ...controlCommands,
  ...controlLists,
  ...daemonCommands,
  doctorCommand,
  ...interfaceCommands,
  launchCommand,
  ...lifecycleCommands,
  ...nodeCommands,
  ...paramCommands,
  pkgCreate,
  ...pkgCommands,
  runCommand,
  ...serviceCommands,
  serviceEcho,
  ...topicCommands,
  topicEcho,
  ...topicMeasures,
  topicPub,
  wtfCommand,
];
