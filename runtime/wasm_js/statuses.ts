// Which endpoint has which status.

import { EndpointKind, StatusKind } from '../protocol/generated/constants.ts';

/** Publishers offer, subscriptions request; clients and servers do both. */
export function hasStatus(endpoint: number, status: StatusKind): boolean {
  if (status < StatusKind.livelinessChanged || status > StatusKind.publicationMatched) return false;
  const ofReader = status <= StatusKind.subscriptionMatched;
  return endpoint !== (ofReader ? EndpointKind.publisher : EndpointKind.subscription);
}
