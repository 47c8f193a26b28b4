import type * as z from 'zod/mini';
import { anyOf, type LocalizedText, listed, type Message, msg } from '../../messages/message.ts';
import { PATTERN_RULES, VALUE_RULE } from './document.ts';

/** What a value ought to be, from the issue that a schema found. */
export function schemaRule(issue: z.core.$ZodIssue, value: unknown): Message {
  switch (issue.code) {
    case 'invalid_type':
      return msg`expected ${kindName(issue.expected)}, received ${kindName(kindOf(value))}`;
    case 'invalid_value':
      return msg`expected ${anyOf(issue.values.map((each) => JSON.stringify(each)))}`;
    case 'unrecognized_keys':
      return msg`unknown: ${listed(issue.keys.map((key) => JSON.stringify(key.slice(0, 80))))}; leave it out`;
    case 'too_big': {
      const most = Number(issue.maximum);
      if (issue.origin === 'string') return msg`longer than ${most} characters`;
      return issue.origin === 'array' ? msg`more than ${most} entries` : msg`more than ${most}`;
    }
    case 'too_small': {
      const least = Number(issue.minimum);
      if (issue.origin === 'string') return msg`an empty text`;
      return issue.origin === 'array' ? msg`fewer than ${least} entries` : msg`less than ${least}`;
    }
    case 'invalid_format':
      return PATTERN_RULES.get(issue.pattern ?? '') ?? msg`text in another form than expected`;
    case 'invalid_key': {
      const [inner] = issue.issues;
      return msg`a name that is not allowed: ${inner ? schemaRule(inner, issue.path.at(-1)) : ''}`;
    }
    case 'invalid_union':
      return VALUE_RULE;
    default:
      return msg`none of the expected values`;
  }
}

const KIND_NAMES: Readonly<Record<string, Message>> = {
  string: msg`a text`,
  number: msg`a number`,
  int: msg`a whole number`,
  boolean: msg`true or false`,
  array: msg`a list`,
  tuple: msg`a list`,
  object: msg`an object`,
  record: msg`an object`,
  undefined: msg`nothing`,
  null: msg`null`,
};

const kindName = (kind: string): LocalizedText => (Object.hasOwn(KIND_NAMES, kind) ? KIND_NAMES[kind]! : kind);
const kindOf = (value: unknown): string => (value === null ? 'null' : Array.isArray(value) ? 'array' : typeof value);
