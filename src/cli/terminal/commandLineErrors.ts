import type { Command, CommanderError, Option } from 'commander';
import { inLines, listed, type Message, msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { CliError, EXIT } from './exitCodes.ts';

/** Wrong use of a command. */
export class CommandLineError extends CliError {
  constructor(what: Message, command: Command) {
    super(EXIT.usage, inLines([msg`error: ${what}`, msg`(${`${fullName(command)} --help`} tells more)`]));
  }
}

/** Thrown by parsers of flag values: what was expected. */
export class InvalidValue extends MessageError {}

/** Lets a command and its subcommands throw `CommandLineError` instead of printing commander's English. `args`: all. */
export function throwOwnErrors(command: Command, args: readonly string[]): void {
  command.configureOutput({ outputError: () => {} }).exitOverride((error) => {
    const what = describe(error, command, args);
    throw what ? new CommandLineError(what, command) : error;
  });
  for (const option of command.options) checkValues(command, option);
  for (const sub of command.commands) throwOwnErrors(sub, args);
}

function checkValues(command: Command, option: Option): void {
  const { parseArg, argChoices, flags } = option;
  if (!parseArg) return;
  const refuse = (value: string, why: Message): never => {
    throw new CommandLineError(msg`option '${flags}' argument '${value}' is invalid. ${why}`, command);
  };
  option.argParser((value: string, before: unknown) => {
    if (argChoices?.includes(value) === false) refuse(value, msg`Allowed choices are ${listed(argChoices)}.`);
    try {
      return parseArg(value, before);
    } catch (error) {
      if (error instanceof InvalidValue) return refuse(value, error.text);
      throw error;
    }
  });
}

/** What commander rejects; undefined if it is no error. */
function describe(error: CommanderError, command: Command, args: readonly string[]): Message | undefined {
  const last = args.at(-1);
  const { registeredArguments: expected, args: given } = command;
  switch (error.code) {
    case 'commander.unknownCommand':
      return suggesting(msg`unknown command '${given[0] ?? ''}'`, error, command);
    case 'commander.unknownOption': {
      // Commander puts what it does not know after the operands.
      const flag = given.find((arg) => /^-./.test(arg)) ?? '';
      return suggesting(msg`unknown option '${flag}'`, error, command);
    }
    case 'commander.missingArgument':
      return msg`missing required argument '${expected[given.length]?.name() ?? ''}'`;
    case 'commander.optionMissingArgument': {
      const option = command.options.find(({ short, long }) => last === short || last === long);
      return msg`option '${option?.flags ?? ''}' argument missing`;
    }
    case 'commander.excessArguments':
      return tooMany(command, expected.length, given.length);
    default:
      return error.exitCode === 0 || error.code.startsWith('commander.help') ? undefined : msg`${error.message}`;
  }
}

function tooMany(command: Command, expected: number, given: number): Message {
  const what = command.parent ? msg`too many arguments for '${command.name()}'` : msg`too many arguments`;
  return expected === 1
    ? msg`${what}. Expected 1 argument but got ${given}.`
    : msg`${what}. Expected ${expected} arguments but got ${given}.`;
}

/** Adds the names that commander suggests: those of the command that its message has after the first line. */
function suggesting(what: Message, { message }: CommanderError, command: Command): Message {
  const names = new Set(namesIn(command));
  const similar =
    message
      .split('\n')
      .slice(1)
      .join()
      .match(/[\w-]+/g)
      ?.filter((word) => names.has(word)) ?? [];
  if (similar.length === 0) return what;
  const question =
    similar.length > 1 ? msg`(Did you mean one of ${listed(similar)}?)` : msg`(Did you mean ${listed(similar)}?)`;
  return inLines([what, question]);
}

/** Of its subcommands and options, and of the options of what it is a part of. */
function namesIn(command: Command): readonly string[] {
  const help = command.createHelp();
  return [
    ...help.visibleCommands(command).map((sub) => sub.name()),
    ...help.visibleOptions(command).flatMap(({ long }) => long ?? []),
    ...(command.parent ? namesIn(command.parent) : []),
  ];
}

const fullName = (command: Command): string =>
  command.parent ? `${fullName(command.parent)} ${command.name()}` : command.name();
