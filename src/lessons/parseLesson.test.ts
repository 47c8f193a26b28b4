import { expect, it } from 'vitest';
import { textOfStep } from './inlines.ts';
import { parseLesson } from './parseLesson.ts';
import { stateAtStep } from './settings.ts';

const HEAD =
  '# Title\n\n```lesson\nplace = 1\nminutes = 5\n```\n\nSummary.\n\n## One\n\n```set\nexample = a.usdc\ntime = 2\n```\n';
const QUESTION =
  '### What?\n\n- [ ] This.\n  No.\n- [x] That *thing*.\n  Yes,\n  so.\n\n```see\ntime = 3\n```\n\nBecause.\n';

it('reads texts, settings, a question and claims', () => {
  const text = `A **b** \`c\` [d](?lesson=e&step=2).\n\n- one\n  more\n- two\n\n\`\`\`formula\nx = y*z\n\`\`\`\n`;
  const { title, place, minutes, steps } = parseLesson(
    `${HEAD}\n${text}\n${QUESTION}\n\`\`\`claim\ng(1, 0.5) = 2.0\n\`\`\`\n`,
    'a.md',
  );
  expect([title, place, minutes, steps.length]).toEqual(['Title', 1, 5, 1]);
  const [step] = steps;
  expect(step!.text).toEqual([
    {
      kind: 'paragraph',
      content: [
        'A ',
        { kind: 'strong', text: 'b' },
        ' ',
        { kind: 'code', text: 'c' },
        ' ',
        { kind: 'link', text: 'd', address: '?lesson=e&step=2' },
        '.',
      ],
    },
    { kind: 'list', items: [['one more'], ['two']] },
    { kind: 'formula', text: 'x = y*z' },
  ]);
  expect(step!.question!.answers.map(({ right, why }) => [right, why])).toEqual([
    [false, ['No.']],
    [true, ['Yes, so.']],
  ]);
  expect(step!.claims).toMatchObject([{ quantity: 'g', of: [1, 0.5], printed: '2.0' }]);
  expect(textOfStep(step!)).toContain('That thing.');
});

it('a step is what all before it set; another example begins anew', () => {
  const more = '\n## Two\n\nText.\n\n## Three\n\n```set\nexample = b.usdc\nobserver.beta = 0, 0, -0.5\n```\n\nText.\n';
  const lesson = parseLesson(`${HEAD}\nText.\n\n${QUESTION}${more}`, 'a.md');
  const at = (step: number, seen: boolean) => {
    const { example, settings } = stateAtStep(lesson, step, seen);
    return [example, Object.fromEntries(settings)];
  };
  expect(at(0, false)).toEqual(['a.usdc', { time: 2 }]);
  expect(at(0, true)).toEqual(['a.usdc', { time: 3 }]);
  expect(at(1, false)).toEqual(['a.usdc', { time: 3 }]);
  expect(at(2, false)).toEqual(['b.usdc', { 'observer.beta': [0, 0, -0.5] }]);
});

it.each([
  ['', 'a.md:1: a lesson begins with its title'],
  ['# T\n\nText.\n', 'a.md:3: below the title is a block'],
  [`${HEAD.replace('place = 1', 'place = first')}\nText.\n`, 'a.md:4: write place = a whole number'],
  [HEAD.replace('Summary.\n', ''), 'a.md:3: a summary follows'],
  [HEAD, 'a.md:10: a step has a text'],
  [`${HEAD.replace('example = a.usdc\n', '')}\nText.\n`, 'a.md:10: the first step opens a scene'],
  [`${HEAD}\n1. first\n`, 'a.md:17: a text is a paragraph or a list'],
  [`${HEAD}\n#### Deep\n`, 'a.md:17: a heading is'],
  [`${HEAD}\n\`\`\`js\nx\n\`\`\`\n`, 'a.md:17: a block is one of'],
  [`${HEAD}\n\`\`\`set\nx\n`, 'a.md:17: this block has no end'],
  [`${HEAD}\nA *b.\n`, 'a.md:17: "*" has no meaning here'],
  [`${HEAD}\n[a](http://b)\n`, 'a.md:17: a link leads to'],
  [`${HEAD}\nText.\n\n\`\`\`set\ncolour\n\`\`\`\n`, 'a.md:20: "colour" is no setting'],
  [`${HEAD}\nText.\n\n\`\`\`set\nobserver.speed = 1\n\`\`\`\n`, 'a.md:20: there is no setting observer.speed'],
  [`${HEAD}\nText.\n\n\`\`\`set\nobserver.beta = 1, 0, 0\n\`\`\`\n`, 'a.md:20: observer.beta is a velocity'],
  [`${HEAD}\nText.\n\n\`\`\`set\ntime = 4\n\`\`\`\n`, 'a.md:20: time is set twice'],
  [`${HEAD}\nText.\n\n\`\`\`set\nexample = b.usdc\n\`\`\`\n`, 'example is set twice'],
  [`${HEAD}\nText.\n\n\`\`\`see\ntime = 4\n\`\`\`\n`, 'a.md:19: this block is out of place'],
  [`${HEAD}\nText.\n\n\`\`\`claim\ng = 2\n\`\`\`\n`, 'a.md:20: "g = 2" is no claim'],
  [`${HEAD}\nText.\n\n\`\`\`claim\ng(a) = 2\n\`\`\`\n`, 'a.md:20: "a" is no number'],
  [`${HEAD}\nText.\n\n### What?\n\nText.\n`, 'a.md:19: answers follow a question'],
  [`${HEAD}\nText.\n\n${QUESTION.replace('[ ]', '[x]')}`, 'a.md:21: one answer is right'],
  [`${HEAD}\nText.\n\n${QUESTION.replace('  No.\n', '')}`, 'a.md:21: below an answer'],
  [`${HEAD}\nText.\n\n${QUESTION.replace('Because.\n', '')}`, 'a.md:21: an explanation follows'],
  [`${HEAD}\nText.\n\n${QUESTION}\n${QUESTION}`, 'a step has one question'],
])('refuses what is written otherwise, with its line (%#)', (source, problem) => {
  expect(() => parseLesson(source, 'a.md')).toThrow(problem);
});
