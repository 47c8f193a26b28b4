import { useEffect } from 'react';
import { create } from 'zustand';

/** How the page is used: by keys and mouse, or by touch. Decided by the last input; at first by the device's main pointer. */
export type InputDevice = 'keys' | 'touch';

/** Whether fingers are the device's main pointer. */
export const isCoarse: boolean = globalThis.matchMedia?.('(pointer: coarse)').matches === true;

const useStore = create<{ readonly device: InputDevice }>(() => ({ device: isCoarse ? 'touch' : 'keys' }));

export const useInputDevice = (): InputDevice => useStore(({ device }) => device);

/** Follows the last input of the page. */
export function useLastInput(): void {
  useEffect(() => {
    const end = new AbortController();
    const options = { signal: end.signal, capture: true };
    addEventListener('keydown', () => useStore.setState({ device: 'keys' }), options);
    addEventListener(
      'pointerdown',
      ({ pointerType }) => useStore.setState({ device: pointerType === 'touch' ? 'touch' : 'keys' }),
      options,
    );
    return () => end.abort();
  }, []);
}
