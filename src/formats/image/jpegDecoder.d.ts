/** The decoder alone: with the package's index comes an encoder, which every page would load. */
declare module 'jpeg-js/lib/decoder.js' {
  export { decode as default } from 'jpeg-js';
}
