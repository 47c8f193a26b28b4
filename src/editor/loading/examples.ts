import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';
import { fetchFile } from './fetchFile.ts';

/** A scene or project of the gallery, as listed in `examples/index.json`; generated from the files at build time. */
export interface Example {
  /** Path relative to the page: `examples/street.usdc`. */
  readonly source: string;
  /** Name without extension: `street`. */
  readonly name: string;
  readonly title: string;
  readonly lookFor: string;
  /** Address of its thumbnail. */
  readonly thumbnail?: string;
}

export async function loadExamples(): Promise<readonly Example[]> {
  const response = await fetchFile(new URL('examples/index.json', document.baseURI), 'examples/index.json');
  if (!response.ok) throw new MessageError(msg`examples/index.json: the server answers ${response.status}`);
  return response.json() as Promise<readonly Example[]>;
}
