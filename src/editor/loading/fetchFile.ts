import { msg } from '../../messages/message.ts';
import { MessageError } from '../../messages/messageError.ts';

/** `fetch`, with a message of its own where nothing answers. `name` is what the user calls the file. */
export async function fetchFile(address: URL, name: string): Promise<Response> {
  try {
    return await fetch(address);
  } catch {
    throw new MessageError(msg`${name}: nothing answers at its address. Check the network, then open it again`);
  }
}
