import { readFileSync } from 'node:fs';
import { Command, CommanderError } from 'commander';
import { PipelineRefusal } from '../pipelines/pipeline.ts';
import { InputError } from '../scene/types.ts';
import { compareCommand } from './compare/compareCommand.ts';
import { convertCommand } from './convert/convertCommand.ts';
import { requestedExitCode } from './files/outputFile.ts';
import { graphCommand } from './graph/graphCommand.ts';
import { inspectCommand } from './inspect/inspectCommand.ts';
import { probeCommand } from './probe/probeCommand.ts';
import { renderCommand } from './render/renderCommand.ts';
import { serveCommand } from './serve/serveCommand.ts';
import { simulateCommand } from './simulate/simulateCommand.ts';
import { CliError, EXIT, EXIT_MEANINGS } from './terminal/exitCodes.ts';

const exitCodes = [
  '\nExit codes:',
  ...Object.entries(EXIT_MEANINGS).map(([code, meaning]) => `  ${code.padEnd(5)}${meaning}`),
].join('\n');

/** All commands with their flags, in the order of `--help`; their actions are imported lazily. */
export const commands = (): readonly Command[] => [
  renderCommand(),
  probeCommand(),
  inspectCommand(),
  compareCommand(),
  convertCommand(),
  simulateCommand(),
  graphCommand(),
  serveCommand(),
];

/** Runs the command line; returns the exit code. */
export async function main(args: readonly string[]): Promise<number> {
  try {
    await program().parseAsync([...args], { from: 'user' });
    return Number(process.exitCode ?? EXIT.ok);
  } catch (error) {
    return report(error);
  }
}

function program(): Command {
  const program = new Command('slowlight')
    .description('Renders, probes and converts scenes as a relativistic observer sees them.')
    .version(version())
    .addHelpText('after', exitCodes);
  for (const command of commands()) program.addCommand(command);
  for (const command of [program, ...program.commands]) {
    command
      .exitOverride()
      .showHelpAfterError(`(slowlight ${command === program ? '' : `${command.name()} `}--help tells more)`);
  }
  return program;
}

function version(): string {
  const file = new URL('../../../package.json', import.meta.url);
  return (JSON.parse(readFileSync(file, 'utf8')) as { version: string }).version;
}

/** Prints an error and returns the exit code: one line for errors that the user can act on, the stack for bugs. */
function report(error: unknown): number {
  const stopped = requestedExitCode();
  // After a signal any error is a consequence of it.
  if (stopped !== undefined) return stopped;
  if (error instanceof CommanderError) return error.exitCode === 0 ? EXIT.ok : EXIT.usage;
  if (error instanceof CliError) return complain(error.message, error.exitCode);
  if (error instanceof PipelineRefusal) return complain(error.message, EXIT.usage);
  if (error instanceof InputError) return complain(error.message, EXIT.input);
  const stack = error instanceof Error ? (error.stack ?? error.message) : String(error);
  return complain(`this is a fault of Slowlight's own, please report it:\n${stack}`, EXIT.internal);
}

function complain(message: string, exitCode: number): number {
  console.error(`slowlight: ${message}`);
  return exitCode;
}
