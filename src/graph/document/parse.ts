import type * as z from 'zod/mini';
import { DocumentError, documentSchema, type GraphDocument } from './document.ts';
import { findFault } from './integrity.ts';
import { migrate } from './migrations.ts';

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
  const document = parseWithSchema(documentSchema, migrate(data), 'not a Slowlight project');
  const fault = findFault(document);
  if (fault) throw new DocumentError(fault);
  return document;
}

/**
 * Reads the text of a project file, of any version. Throws a DocumentError with the place of the first error.
 * @example
 * parseDocument(serializeDocument(emptyDocument())).version; // 4
 */
export const parseDocument = (text: string): GraphDocument => readDocument(parseJson(text));

/** Parses data by a schema; throws a DocumentError with the place. */
export function parseWithSchema<T>(schema: z.ZodMiniType<T>, data: unknown, otherwise: string): T {
  const result = schema.safeParse(data);
  if (result.success) return result.data;
  const issue = result.error.issues[0];
  const place = issue?.path.join('.').slice(0, MAX_PLACE_LENGTH) || 'the file';
  throw new DocumentError(`${place}: ${issue ? describeIssue(issue.message, data, issue.path) : otherwise}`);
}

/** The error, and the offending value if it is short. */
function describeIssue(message: string, data: unknown, path: readonly PropertyKey[]): string {
  const value = path.reduce<unknown>(
    (within, key) => (within as Record<PropertyKey, unknown> | undefined)?.[key],
    data,
  );
  return ['string', 'number', 'boolean'].includes(typeof value)
    ? `${message}; it is ${JSON.stringify(value).slice(0, MAX_VALUE_LENGTH)}`
    : message;
}

export function parseJson(text: string): unknown {
  if (text.length > MAX_PROJECT_LENGTH) {
    const size = (text.length / 2 ** 20).toFixed(0);
    throw new DocumentError(`the file: ${size} MiB is more than the ${MAX_PROJECT_LENGTH / 2 ** 20} MiB of a project`);
  }
  try {
    return JSON.parse(text);
  } catch (error) {
    throw new DocumentError(`not JSON: ${error instanceof Error ? error.message : String(error)}`);
  }
}
