import { Command } from 'commander';

/** `slowlight graph check|upgrade|docs` */
export function graphCommand(): Command {
  const command = new Command('graph').description(
    'Checks projects, brings them to the current version, and tells what nodes there are.',
  );
  command
    .command('check')
    .description('Tells what is wrong with a project, node by node; files are not opened.')
    .argument('<project>', '.slowlight.json')
    .option('--json', 'print the faults as JSON')
    .action(async (path: string, flags: { json?: boolean }) => (await import('./graphAction.ts')).check(path, flags));
  command
    .command('upgrade')
    .description(
      'Writes a project of any version as one of the current version; the same project always gives the same text.',
    )
    .argument('<project>', '.slowlight.json')
    .option('-o, --output <file>', 'file to write (default: the project itself)')
    .action(async (path: string, flags: { output?: string }) =>
      (await import('./graphAction.ts')).upgrade(path, flags),
    );
  command
    .command('docs')
    .description('Prints the reference of all nodes, in Markdown: sockets, parameters, units, ranges, defaults.')
    .argument('[type]', 'one node type, like relativity-console')
    .action(async (type?: string) => (await import('./graphAction.ts')).docs(type));
  return command;
}
