import type * as z from 'zod/mini';
import { msg } from '../../messages/message.ts';
import { messageOf } from '../../messages/messageError.ts';
import { DocumentError, documentSchema, type GraphDocument } from './document.ts';
import { findFault } from './integrity.ts';
import { migrate } from './migrations.ts';
import { schemaRule } from './schemaRule.ts';

/** Larger texts are not projects [characters]. */
const MAX_PROJECT_LENGTH = 2 ** 24;
/** Maximum length of a place in messages, since keys of damaged files may have any length [characters]. */
const MAX_PLACE_LENGTH = 200;
const MAX_VALUE_LENGTH = 80;

/**
 * Reads parsed JSON of any version. Throws a DocumentError with the place of the first error.
 * @example
 * readDocument({ ...emptyDocument(), title: 'Nothing yet' }).title; // 'Nothing yet'
 */
export function readDocument(data: unknown): GraphDocument {
  const document = parseWithSchema(documentSchema, migrate(data));
  const fault = findFault(document);
  if (fault) throw new DocumentError(fault);
  return document;
}

/**
 * Reads the text of a project file, of any version. Throws a DocumentError with the place of the first error.
 * @example
 * parseDocument(serializeDocument(emptyDocument())).version; // 6
 */
export const parseDocument = (text: string): GraphDocument => readDocument(parseJson(text));

/** Parses data by a schema; throws a DocumentError with the place of the first issue, and its value if it is short. */
export function parseWithSchema<T>(schema: z.ZodMiniType<T>, data: unknown): T {
  const result = schema.safeParse(data);
  if (result.success) return result.data;
  const issue = result.error.issues[0]!;
  const place = issue.path.join('.').slice(0, MAX_PLACE_LENGTH) || msg`the file`;
  const value = issue.path.reduce<unknown>(
    (within, key) => (within as Record<PropertyKey, unknown> | undefined)?.[key],
    data,
  );
  const rule = schemaRule(issue, value);
  const isShort = issue.code !== 'invalid_key' && ['string', 'number', 'boolean'].includes(typeof value);
  throw new DocumentError(
    isShort
      ? msg`${place}: ${msg`${rule}; it is ${JSON.stringify(value).slice(0, MAX_VALUE_LENGTH)}`}`
      : msg`${place}: ${rule}`,
  );
}

export function parseJson(text: string): unknown {
  if (text.length > MAX_PROJECT_LENGTH) {
    const size = (text.length / 2 ** 20).toFixed(0);
    throw new DocumentError(
      msg`the file: ${size} MiB is more than the ${MAX_PROJECT_LENGTH / 2 ** 20} MiB of a project`,
    );
  }
  return jsonOf(text);
}

/** Throws a DocumentError if a text is not JSON. */
export function jsonOf(text: string): unknown {
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new DocumentError(msg`not JSON: ${messageOf(error)}`);
  }
}
