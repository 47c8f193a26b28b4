import { SaxesParser } from 'saxes';
import { msg } from '../../../messages/message.ts';
import { formatBytes, inputError } from '../../diagnostics/inputError.ts';

/** An element of an XML file, without its text. */
export interface XmlElement {
  readonly name: string;
  readonly attributes: ReadonlyMap<string, string>;
  readonly children: XmlElement[];
  /** Counted from 1. */
  readonly line: number;
}

/** Maximum size of a document [bytes]. */
export const MAX_XML_BYTES = 2 ** 24;
/** Maximum number of elements of a document. */
export const MAX_XML_ELEMENTS = 100_000;
/** Maximum depth of elements. */
export const MAX_XML_DEPTH = 32;

/**
 * The root element of an XML file. A DOCTYPE is skipped, its entities are not defined: only those of XML itself are.
 * Throws an InputError that names file, line and column.
 */
export function parseXml(bytes: Uint8Array, file: string): XmlElement {
  if (bytes.length > MAX_XML_BYTES)
    throw inputError(
      'mtlx.too-large',
      file,
      msg`the document has ${formatBytes(bytes.length)}; at most ${formatBytes(MAX_XML_BYTES)} are read`,
    );
  const parser = new SaxesParser();
  const open: XmlElement[] = [];
  let root: XmlElement | undefined;
  let count = 0;
  const fail = (message: ReturnType<typeof msg>): never => {
    throw inputError('mtlx.syntax', file, msg`line ${parser.line}, column ${parser.column}: ${message}`);
  };
  // The parser puts its own place, line:column, in front of what it says.
  parser.on('error', ({ message }) => fail(msg`the XML is not well-formed: ${message.replace(/^\d+:\d+: /, '')}`));
  parser.on('opentag', ({ name, attributes }) => {
    if (++count > MAX_XML_ELEMENTS) fail(msg`there are more than ${MAX_XML_ELEMENTS} elements`);
    if (open.length >= MAX_XML_DEPTH) fail(msg`elements are nested more than ${MAX_XML_DEPTH} deep`);
    const element = { name, attributes: new Map(Object.entries(attributes)), children: [], line: parser.line };
    open.at(-1)?.children.push(element);
    root ??= element;
    open.push(element);
  });
  parser.on('closetag', () => open.pop());
  parser.write(new TextDecoder().decode(bytes)).close();
  return root ?? fail(msg`there is no element`);
}
