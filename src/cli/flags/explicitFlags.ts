import type { Command } from 'commander';

/** Names of the explicitly given flags. */
export const explicitFlags = (command: Command): ReadonlySet<string> =>
  new Set(Object.keys(command.opts()).filter((name) => command.getOptionValueSource(name) === 'cli'));
