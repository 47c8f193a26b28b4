import { type Command, Option } from 'commander';
import { msg } from '../../messages/message.ts';
import { localized } from '../terminal/language.ts';
import { addText } from './parse.ts';
import { addSceneFlags, type SceneFlags } from './sceneFlags.ts';
import { addStandpointFlags, type StandpointFlags, speedOfLightOption } from './viewFlags.ts';

/** Flags of commands that look at a scene, or at that of a project, without drawing a picture. */
export interface SceneOrProjectFlags extends SceneFlags, StandpointFlags {
  /** For projects: `node.param=value`. */
  readonly set?: readonly string[];
}

/** `--set` of commands that take a project as well as a scene file. */
export const projectSetOption = (): Option =>
  new Option(
    '--set <node.param=value>',
    localized(msg`for a project: set a parameter of a node; repeatable; vectors as x,y,z`),
  ).argParser(addText);

export const addSceneOrProjectFlags = (command: Command): Command =>
  addStandpointFlags(addSceneFlags(command)).addOption(speedOfLightOption()).addOption(projectSetOption());
