import type { ReactNode } from 'react';

/** A light cone, with the incoming half blue and the outgoing half red. */
export const Logo = (): ReactNode => (
  <svg width="22" height="22" viewBox="0 0 22 22" aria-hidden="true">
    <path d="M3 2.5 L19 2.5 L11 11 Z" fill="#e0604c" />
    <path d="M3 19.5 L19 19.5 L11 11 Z" fill="#3d7cdf" />
    <circle cx="11" cy="11" r="2.4" fill="#fff" stroke="#1b2029" strokeWidth="1.2" />
  </svg>
);
