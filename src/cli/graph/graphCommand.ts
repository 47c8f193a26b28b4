import { Command } from 'commander';

/** `slowlight graph check|upgrade|docs` */
export function graphCommand(): Command {
  const command = new Command('graph').description(
    'Checks and upgrades projects, and prints the reference of all nodes.',
  );
  command
    .command('check')
    .description('Reports errors in projects, node by node, without opening the files that they use.')
    .argument('<projects...>', '.slowlight.json')
    .option('--json', 'print the errors as JSON; for several projects, a list')
    .action(async (paths: string[], flags: { json?: boolean }) =>
      (await import('./graphAction.ts')).check(paths, flags),
    );
  command
    .command('upgrade')
    .description('Upgrades a project to the current version; the same project always gives the same text.')
    .argument('<project>', '.slowlight.json')
    .option('-o, --output <file>', 'output file (default: the project itself)')
    .action(async (path: string, flags: { output?: string }) =>
      (await import('./graphAction.ts')).upgrade(path, flags),
    );
  command
    .command('docs')
    .description('Prints the reference of all nodes, in Markdown: sockets, parameters, units, ranges, defaults.')
    .argument('[type]', 'a single node type, such as relativity-console')
    .action(async (type?: string) => (await import('./graphAction.ts')).docs(type));
  return command;
}
