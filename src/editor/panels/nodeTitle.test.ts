import { expect, it } from 'vitest';
import { english } from '../../../tests/support/inWords.ts';
import { newProject } from '../../nodes/project/projectCommands.ts';
import { displayTitle, placeTitle, userTitle } from './nodeTitle.ts';

const project = newProject('a.usda');

it('a node’s title is the user’s, else that of its type; other ids have none', () => {
  expect(userTitle(project, 'falseColour')).toBeUndefined();
  expect(english(displayTitle(project, 'falseColour'))).toBe('False colour');
  const { falseColour } = project.nodes;
  const named = { ...project, nodes: { ...project.nodes, falseColour: { ...falseColour!, title: 'Bands' } } };
  expect([userTitle(named, 'falseColour'), displayTitle(named, 'falseColour')]).toEqual(['Bands', 'Bands']);
  expect(displayTitle(project, '/World/Cube')).toBeUndefined();
});

it('a place names the node, and its parameter', () => {
  expect(english(placeTitle(project, 'falseColour'))).toBe('False colour');
  expect(english(placeTitle(project, 'console.speedOfLight'))).toBe('Relativity console: Speed of light');
  expect(placeTitle(project, 'console.nothing')).toBeUndefined();
  expect(placeTitle(project, '/World/Cube')).toBeUndefined();
  expect(placeTitle(project, 'scene.usda')).toBeUndefined();
});
