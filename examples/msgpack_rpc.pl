#!/usr/bin/env perl
# The robot from another language, without any library: MessagePack-RPC over TCP, here in Perl.
# Start the daemon with a port for it, `usarnaoqi serve --msgpack-port 9560`, then:
#   examples/msgpack_rpc.pl [host] [port]
use strict;
use warnings;
use IO::Socket::INET;

my $host = shift // '127.0.0.1';
my $port = shift // 9560;
my $socket = IO::Socket::INET->new(PeerAddr => $host, PeerPort => $port)
  or die "nobody answers at $host:$port\n";
my $number = 0;

# What Perl holds, as MessagePack: lists, texts, whole numbers and others.
sub packed {
    my ($value) = @_;
    return "\xc0" unless defined $value;
    return pack('Cn', 0xdc, scalar @$value) . join '', map { packed($_) } @$value if ref $value;
    return pack('CN', 0xd2, $value & 0xffffffff) if $value =~ /^-?\d{1,9}$/;
    return pack('Cd>', 0xcb, $value) if $value =~ /^-?\d*\.\d+$/;
    return pack('CN/a*', 0xdb, $value);
}

sub bytes {
    my ($count) = @_;
    read($socket, my $data, $count) == $count or die "the robot has gone\n";
    return $data;
}

# The next value of the stream.
sub unpacked {
    my $kind = ord bytes(1);
    return $kind if $kind < 0x80;
    return $kind - 0x100 if $kind >= 0xe0;
    return [map { unpacked() } 1 .. $kind & 0x0f] if ($kind & 0xf0) == 0x90;
    return bytes($kind & 0x1f) if ($kind & 0xe0) == 0xa0;
    return undef if $kind == 0xc0;
    return $kind & 1 if $kind == 0xc2 or $kind == 0xc3;
    my %number = (0xca => 'f>', 0xcb => 'd>', 0xcc => 'C', 0xcd => 'n', 0xce => 'N', 0xcf => 'Q>',
        0xd0 => 'c', 0xd1 => 's>', 0xd2 => 'l>', 0xd3 => 'q>');
    return unpack $number{$kind}, bytes(length pack $number{$kind}, 0) if $number{$kind};
    my %text = (0xc4 => 'C', 0xc5 => 'n', 0xc6 => 'N', 0xd9 => 'C', 0xda => 'n', 0xdb => 'N');
    return bytes(unpack $text{$kind}, bytes(length pack $text{$kind}, 0)) if $text{$kind};
    my %list = (0xdc => 'n', 0xdd => 'N');
    return [map { unpacked() } 1 .. unpack $list{$kind}, bytes(length pack $list{$kind}, 0)]
      if $list{$kind};
    die sprintf "a value of kind %#x was not expected\n", $kind;
}

# Calls Service.method and waits for its result; dies with the robot's text if it fails.
sub call {
    my ($method, @arguments) = @_;
    print $socket packed([0, ++$number, $method, \@arguments]);
    $socket->flush;
    my ($type, $id, $error, $result) = @{unpacked()};
    die "$method: $error\n" if defined $error;
    return $result;
}

call('ALMotion.setStiffnesses', 'Head', 1.0);
call('ALMotion.angleInterpolation', 'HeadYaw', 0.4, 1.0, 1);
printf "HeadYaw is at %.2f rad\n", call('ALMotion.getAngles', 'HeadYaw', 1)->[0];
call('ALTextToSpeech.say', 'Hello from Perl');
printf "the robot has %d joints\n", scalar @{call('ALMotion.getBodyNames', 'Body')};
