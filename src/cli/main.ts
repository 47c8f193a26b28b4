import { readFileSync } from 'node:fs';
import { parseArgs } from 'node:util';
import { Command, CommanderError, Option } from 'commander';
import { LANGUAGE_TAGS } from '../messages/languages.ts';
import { type Message, msg } from '../messages/message.ts';
import { PipelineRefusal } from '../pipelines/pipeline.ts';
import { InputError } from '../scene/types.ts';
import { clocksCommand } from './clocks/clocksCommand.ts';
import { compareCommand } from './compare/compareCommand.ts';
import { convertCommand } from './convert/convertCommand.ts';
import { diagramCommand } from './diagram/diagramCommand.ts';
import { requestedExitCode } from './files/outputFile.ts';
import { flightCommand } from './flight/flightCommand.ts';
import { graphCommand } from './graph/graphCommand.ts';
import { inspectCommand } from './inspect/inspectCommand.ts';
import { probeCommand } from './probe/probeCommand.ts';
import { renderCommand } from './render/renderCommand.ts';
import { serveCommand } from './serve/serveCommand.ts';
import { simulateCommand } from './simulate/simulateCommand.ts';
import { CommandLineError, throwOwnErrors } from './terminal/commandLineErrors.ts';
import { CliError, EXIT, EXIT_MEANINGS } from './terminal/exitCodes.ts';
import { localizeHelp, section } from './terminal/help.ts';
import { chosenLanguage, localized, setLanguage } from './terminal/language.ts';

/** All commands with their flags, in the order of `--help`; their actions are imported lazily. */
export const commands = (): readonly Command[] => [
  renderCommand(),
  probeCommand(),
  inspectCommand(),
  diagramCommand(),
  clocksCommand(),
  compareCommand(),
  convertCommand(),
  simulateCommand(),
  graphCommand(),
  flightCommand(),
  serveCommand(),
];

/** Runs the command line; returns the exit code. */
export async function main(args: readonly string[]): Promise<number> {
  try {
    await setLanguage(chosenLanguage(languageFlag(args), process.env));
    await program(args).parseAsync([...args], { from: 'user' });
    return Number(process.exitCode ?? EXIT.ok);
  } catch (error) {
    return report(error);
  }
}

/** The value of `--lang`: it is wanted before there are texts of commands, and checked with the other flags. */
const languageFlag = (args: readonly string[]): unknown =>
  parseArgs({ args: [...args], options: { lang: { type: 'string' } }, strict: false }).values.lang;

function program(args: readonly string[]): Command {
  const program = new Command('slowlight')
    .description(localized(msg`Renders, probes and converts scenes as a relativistic observer sees them.`))
    .version(version(), '-V, --version', localized(msg`output the version number`))
    .addOption(
      new Option(
        '--lang <tag>',
        localized(msg`language of texts, also after a command (default: LANGUAGE, LC_ALL, LC_MESSAGES or LANG)`),
      ).choices(LANGUAGE_TAGS),
    )
    .addHelpText('after', exitCodes());
  for (const command of commands()) program.addCommand(command);
  localizeHelp(program);
  throwOwnErrors(program, args);
  return program;
}

const exitCodes = (): string =>
  section(
    msg`Exit codes:`,
    Object.entries(EXIT_MEANINGS).map(([code, meaning]) => msg`${code.padEnd(5)}${meaning}`),
  );

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
  if (error instanceof CommandLineError) {
    console.error(localized(error.text));
    return error.exitCode;
  }
  if (error instanceof CliError) return complain(error.text, error.exitCode);
  if (error instanceof PipelineRefusal) return complain(error.text, EXIT.usage);
  if (error instanceof InputError) return complain(error.text, EXIT.input);
  const stack = error instanceof Error ? (error.stack ?? error.message) : String(error);
  return complain(msg`this is a fault of Slowlight's own, please report it:\n${stack}`, EXIT.internal);
}

function complain(text: Message, exitCode: number): number {
  console.error(`slowlight: ${localized(text)}`);
  return exitCode;
}
