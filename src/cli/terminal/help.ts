import { type Command, Help, type Option } from 'commander';
import { inLines, type LocalizedText, listed, type Message, msg } from '../../messages/message.ts';
import { localized } from './language.ts';
import { displayWidth } from './width.ts';

/** Commander's headings. */
const HEADINGS: Readonly<Record<string, Message>> = {
  'Usage:': msg`Usage:`,
  'Arguments:': msg`Arguments:`,
  'Options:': msg`Options:`,
  'Commands:': msg`Commands:`,
};

/** Where a line may break beside a full-width character: not before closing punctuation, nor after opening. */
const LINE_BREAKS =
  /(?<![\s（「《“])(?:(?<=[\u2e80-\ua4cf\uff00-\uff60])|(?=[\u2e80-\ua4cf\uff00-\uff60]))(?![\s、。，；：！？）」》”…)]|$)/gu;
/** White space of no width, which marks these places for `boxWrap`. */
const NO_WIDTH = '\ufeff';

/** Commander's help in the user's language. */
class LocalizedHelp extends Help {
  override formatHelp(command: Command, helper: Help): string {
    return super.formatHelp(command, helper).replace('： ', '：');
  }

  override styleTitle(heading: string): string {
    return localized(HEADINGS[heading] ?? heading);
  }

  override styleUsage(usage: string): string {
    return placeholders(usage);
  }

  override styleSubcommandTerm(term: string): string {
    return placeholders(term);
  }

  override optionDescription({ description, argChoices, defaultValue, ...option }: Option): string {
    const isFlag = !option.required && !option.optional;
    const hasDefault = defaultValue !== undefined && (!isFlag || typeof defaultValue === 'boolean');
    const choices = argChoices && listed(argChoices.map((choice) => JSON.stringify(choice)));
    const fallback = hasDefault && (option.defaultValueDescription || JSON.stringify(defaultValue));
    if (!choices && !fallback) return description;
    const facts =
      choices && fallback
        ? msg`choices: ${choices}, default: ${fallback}`
        : choices
          ? msg`choices: ${choices}`
          : msg`default: ${fallback || ''}`;
    return localized(msg`${description} (${facts})`);
  }

  override displayWidth(text: string): number {
    return displayWidth(text.replaceAll(NO_WIDTH, ''));
  }

  override boxWrap(text: string, width: number): string {
    return super.boxWrap(text.replace(LINE_BREAKS, NO_WIDTH), width).replaceAll(NO_WIDTH, '');
  }
}

const placeholders = (usage: string): string =>
  usage.replace('[options]', `[${localized(msg`options`)}]`).replace('[command]', `[${localized(msg`command`)}]`);

/** Lets the help of a command and its subcommands speak the user's language. */
export function localizeHelp(command: Command): void {
  const description = localized(msg`display help for command`);
  command.createHelp = () => new LocalizedHelp();
  command.helpOption('-h, --help', description);
  if (command.commands.length > 0) command.helpCommand('help [command]', description);
  command.commands.forEach(localizeHelp);
}

/** A section after the help. */
export const section = (heading: Message, lines: readonly LocalizedText[]): string =>
  localized(inLines([msg`\n${heading}`, ...lines.map((line) => msg`  ${line}`)]));

/** Examples after the help. */
export const examples = (lines: readonly string[]): string => section(msg`Examples:`, lines);
