/** For nodes that read nothing. */
export const noFiles = {
  readFile: (source: string): Promise<Uint8Array> => Promise.reject(new Error(`${source} is not there`)),
};
