import type { NodeCategory } from '../graph/nodeType.ts';
import { type LocalizedText, type Message, msg } from '../messages/message.ts';
import type { SocketType } from './defineNode.ts';

/** Titles of the categories of nodes, in the order of menus and of the reference page. */
export const CATEGORY_TITLES: Readonly<Record<NodeCategory, Message>> = {
  geometry: msg`Geometry`,
  dynamics: msg`Dynamics`,
  composition: msg`Composition`,
  render: msg`Render`,
  utility: msg`Utility`,
};

const SOCKET_TITLES: Readonly<Record<Exclude<SocketType, 'any' | 'file'>, Message>> = {
  geometry: msg`Geometry`,
  motion: msg`Motion`,
  matter: msg`Matter`,
  books: msg`Run record`,
  lights: msg`Lights`,
  observer: msg`Observer`,
  time: msg`Time`,
  spectrum: msg`Spectrum`,
  scene: msg`Scene`,
  relativity: msg`Relativity`,
  view: msg`View`,
  gbuffer: msg`G-buffer`,
  image: msg`Image`,
  picture: msg`Picture`,
  mask: msg`Mask`,
  number: msg`Number`,
  vector: msg`Vector`,
  color: msg`Colour`,
  text: msg`Text`,
};

/** Title of a type of sockets, for sockets without a title of their own. */
export const socketTitle = (type: string): LocalizedText =>
  Object.hasOwn(SOCKET_TITLES, type) ? SOCKET_TITLES[type as keyof typeof SOCKET_TITLES] : type;
