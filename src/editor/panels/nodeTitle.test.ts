import { expect, it } from 'vitest';
import { english } from '../../../tests/support/inWords.ts';
import { newProject } from '../../nodes/project/projectCommands.ts';
import { displayTitle, userTitle } from './nodeTitle.ts';

it('a node’s title is the user’s, else that of its type; other ids have none', () => {
  const project = newProject('a.usda');
  expect(userTitle(project, 'falseColour')).toBeUndefined();
  expect(english(displayTitle(project, 'falseColour'))).toBe('False colour');
  const { falseColour } = project.nodes;
  const named = { ...project, nodes: { ...project.nodes, falseColour: { ...falseColour!, title: 'Bands' } } };
  expect([userTitle(named, 'falseColour'), displayTitle(named, 'falseColour')]).toEqual(['Bands', 'Bands']);
  expect(displayTitle(project, '/World/Cube')).toBeUndefined();
});
