// For NODE_OPTIONS=--import: a Node process in which the GPU and browser libraries cannot be loaded.
import { register } from 'node:module';

const hooks = `export const resolve = (name, context, next) => {
  if (/^(webgpu|three|playwright-core)(\\/|$)/.test(name)) throw new Error(name + ' must not be loaded here');
  return next(name, context);
};`;
register(`data:text/javascript,${encodeURIComponent(hooks)}`);
