import type { Editor } from '../../state/editor.ts';
import type { ObserverController } from '../observerController.ts';
import { FlightDeck } from './deck.ts';

let deck: FlightDeck | undefined;

/** The deck of the page, with its pilot in charge. */
export function openDeck(editor: Editor, observerController: ObserverController): FlightDeck {
  deck ??= new FlightDeck(editor, () => observerController.inputs.screen?.letGo());
  observerController.pilot = deck.pilot;
  return deck;
}
